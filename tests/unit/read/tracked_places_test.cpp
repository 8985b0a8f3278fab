// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "unit/read/scene_support.hpp"

// What tracked_at finds: a place within an element of a mesh, the nearest of material points.

namespace tether::test {
namespace {

using Texts = std::vector<std::string>;

/// A block of 2 x 2 elements on [0, 1]^2, or of 2 x 2 x 2 elements; `at` is on line 7.
Built block_that_tracks(const std::string& at, const std::string& kind = "q1", bool space = false) {
  return build_on_mesh(
      on_unit_square("$\n$reg nreg=1,nvi=4,xvi(1,1)=0.,1.,1.,0.,yvi(1,1)=0.,0.,1.,1.,densir=1.,matr(1,1)=1.,.3 $\n") +
      "$fem fix_on(1)='1.left',fix(1,1)=0.,0. $\n$mesh element='" + kind + "',cells(1,1)=2,2" +
      (space ? ",cells(3,1)=2,z=0.,1." : "") + ",tracked_z(1)=.3 $\n$points tracked_at(1,1)=" + at + " $\n");
}

/// Where the parts of the shape at the start put the place: that which was asked for.
void expect_found(const std::string& kind, bool space) {
  const Built built = block_that_tracks(".3,.9", kind, space);
  ASSERT_EQ(built.errors(), Texts{});
  const Solids& solids = *built.scene.solids();
  ASSERT_EQ(solids.tracked.size(), 1u);
  const std::size_t dim = space ? 3 : 2;
  const double asked[] = {.3, .9, .3};
  for (std::size_t i = 0; i < dim; ++i)
    EXPECT_NEAR(solids.tracked[0].place.of(solids.mesh.x, dim, i), asked[i], 1e-15) << kind << " " << i;
  EXPECT_EQ(solids.tracked[0].name, space ? "place (0.3, 0.9, 0.3)" : "place (0.3, 0.9)");
}

TEST(TrackedPlaces, AreFoundWithinEveryKindOfElement) {
  for (const char* kind : {"q1", "q2", "p1"}) expect_found(kind, false), expect_found(kind, true);
}

TEST(TrackedPlaces, AtANodeAreTheNodeAlone) {
  const Built built = block_that_tracks("1.,.5");
  ASSERT_EQ(built.errors(), Texts{});
  EXPECT_EQ(built.scene.solids()->tracked[0].place.parts, std::vector<double>{1});
  EXPECT_EQ(built.scene.solids()->tracked[0].name, "node 6 at (1, 0.5)");
}

TEST(TrackedPlaces, OutsideOfEveryBodyAreMistakes) {
  EXPECT_EQ(block_that_tracks("1.0000001,.5").errors(), Texts{});
  EXPECT_EQ(
      block_that_tracks("1.000001,.5").errors(),
      Texts{"7:25: (1, 0.5) lies in no body: it is about 1e-06 outside of the nearest element, 2e-06 of its size"});
  EXPECT_EQ(
      block_that_tracks("1.5,1.5").errors(),
      Texts{"7:25: (1.5, 1.5) lies in no body: it is about 0.707 outside of the nearest element, 1.4 of its size"});
}

TEST(TrackedPlaces, OfMaterialPointsAreTheNearestPointsWhoseDistanceIsSaid) {
  const Built built = build(string_deck("$points tracked_at(1,1)=.4,.9 $\n"));
  ASSERT_EQ(built.diagnostics.all().size(), 1u);
  EXPECT_EQ(built.diagnostics.all()[0].severity, Severity::remark);
  EXPECT_EQ(built.diagnostics.all()[0].message,
            "what is tracked is the nearest point, number 2 at (0.375, 0.5), 0.401 from (0.4, 0.9)");
  EXPECT_EQ(tracked_name(built.scene, 0), "point 2, 0.401 from (0.4, 0.9)");
}

}  // namespace
}  // namespace tether::test
