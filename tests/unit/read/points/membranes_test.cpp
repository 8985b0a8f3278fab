// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "unit/read/points/membranes_support.hpp"
#include "unit/total.hpp"

namespace tether::test {
namespace {

using std::numbers::pi;

TEST(Membranes, HaveThePointsOfTheirCurves) {
  const Built built = one_line("count(1)=4");
  ASSERT_EQ(built.errors(), Texts{});
  EXPECT_EQ(warnings(built), Texts{});
  const PointSet& points = built.scene.points;
  ASSERT_EQ(points.size(), 4u);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(points.x[k], .2 + .2 * static_cast<double>(k), 1e-15);
    EXPECT_EQ(points.y[k], .5);
    EXPECT_NEAR(points.volume[k], .01 * .2, 1e-17);
    EXPECT_NEAR(points.mass[k], 2 * .01 * .2, 1e-17);
  }
  for (const auto* zeros : {&points.vx, &points.vy, &points.sxx, &points.syy, &points.sxy}) {
    EXPECT_EQ(*zeros, std::vector<double>(4, 0.0));
  }
}

TEST(Membranes, AreBodiesWithTheirOwnLaw) {
  const Scene scene = one_line("count(1)=4,law(1)='plane-stress',poisson(1)=.3,wrinkle(1)=.false.").scene;
  ASSERT_EQ(scene.bodies.size(), 1u);
  const Body& body = scene.bodies[0];
  EXPECT_EQ(body.name, "membrane 1");
  EXPECT_EQ(body.density, 2);
  EXPECT_EQ(body.count, 4u);
  EXPECT_FALSE(body.closed);
  const auto law = std::get<Membrane>(body.material);
  EXPECT_EQ(law.E, 100);
  EXPECT_EQ(law.nu, .3);
  EXPECT_FALSE(law.wrinkle);
  EXPECT_EQ(law.kind, Membrane::Kind::plane_stress);
  const auto plain = std::get<Membrane>(one_line("count(1)=4").scene.bodies[0].material);
  EXPECT_TRUE(plain.wrinkle);
  EXPECT_EQ(plain.kind, Membrane::Kind::uniaxial);
}

TEST(Membranes, OfASpacingHaveTheNearestNumberOfPoints) {
  EXPECT_EQ(one_line("spacing(1)=.19").scene.points.size(), 4u);
  EXPECT_EQ(one_line("spacing(1)=.2,pinned(1)='both'", "", {"membrane.strain='element'"}).scene.points.size(), 5u);
}

/// Whatever the ends, the volumes are thickness times length.
TEST(Membranes, ShareTheWholeVolume) {
  for (const std::string pinned : {"none", "first", "last", "both"}) {
    const Scene scene = one_line("count(1)=7,pinned(1)='" + pinned + "'", "", {"membrane.strain='element'"}).scene;
    EXPECT_NEAR(total(scene.points.volume), .008, 1e-17) << pinned;
    EXPECT_NEAR(total(scene.points.mass), .016, 1e-17) << pinned;
  }
}

TEST(Membranes, PinnedEndsAreVeryEndsAndPinned) {
  const Built built = one_line("count(1)=5,pinned(1)='both',strain='element'");
  ASSERT_EQ(built.errors(), Texts{});
  EXPECT_EQ(warnings(built), Texts{});
  EXPECT_EQ(built.scene.pinned, (std::vector<std::size_t>{0, 4}));
  EXPECT_EQ(built.scene.points.x.front(), .1);
  EXPECT_EQ(built.scene.points.x.back(), .9);
  EXPECT_EQ(one_line("count(1)=5,pinned(1)='last'", "", {"mpm.method='robust'"}).scene.pinned,
            (std::vector<std::size_t>{4}));
}

TEST(Membranes, APinWithoutElementsHoldsItsPointAloneAndSaysSo) {
  const Built built = one_line("count(1)=5,pinned(1)='first'");
  EXPECT_EQ(warnings(built), (Texts{"7:22: where strain is measured at points a pin holds its point alone, not the "
                                    "nodes around it, which carry the load"}));
  EXPECT_EQ(built.scene.pinned, (std::vector<std::size_t>{0}));
  EXPECT_EQ(built.scene.points.x.front(), .1);
}

TEST(Membranes, StandBehindRegionsAndFileWithIgen3AndAreAddedWhateverIgenIs) {
  const std::string groups =
      "$membrane\ncurve(1)='arc',a(1)=.2,xc(1)=.5,yc(1)=.5,count(1)=3,density(1)=2.,young(1)=1.,thickness(1)=.1\n$\n"
      "$reg\nnreg=1,nvi=4,xvi(1,1)=.25,.75,.75,.25,yvi(1,1)=.25,.25,.75,.75\ndensir=3.,ipath(4,1)=0,matr(1,1)=10.,."
      "25\n$\n$points heavy(2)=7.,tracked_at(1,1)=.3,.5 $\n";
  const auto bodies = [&](const std::string& igen) {
    const Built built = build(string_deck(groups, igen));
    EXPECT_EQ(built.errors(), Texts{});
    Texts names;
    for (const Body& body : built.scene.bodies) names.push_back(body.name);
    if (igen == "igen=3") {
      EXPECT_EQ(built.scene.bodies[2].first, 19u);
      EXPECT_EQ(built.scene.points.mass[17], 7);
      EXPECT_EQ(built.scene.tracked, (std::vector<std::size_t>{16 + 3 + 1}));  // the arc's middle
    }
    return names;
  };
  EXPECT_EQ(bodies("igen=3"), (Texts{"region 1", "particle file", "membrane 1"}));
  EXPECT_EQ(bodies("igen=0"), (Texts{"particle file", "membrane 1"}));
}

TEST(Membranes, NeedNoParticleFileWithIgen3NorRegionsWithIgen1) {
  EXPECT_EQ(one_line("count(1)=4", "igen=3\n").errors(), Texts{});
  EXPECT_EQ(one_line("count(1)=4", "igen=1\n").errors(), Texts{});
  EXPECT_EQ(one_line("count(1)=4", "igen=0\n").errors(),
            (Texts{"3:6: igen = 0 takes points from a particle file, and none is named"}));
}

TEST(Membranes, OfOneBodyAreJoinedInTheOrderOfTheirCurves) {
  const Built built = membranes(
      "curve(2)='line',body(2)=2,x(1,2)=0.,1.,y(1,2)=0.,0.\n"
      "curve(4)='line',body(4)=2,x(1,4)=1.,1.,y(1,4)=0.,1.\n"
      "curve(3)='line',x(1,3)=0.,1.,y(1,3)=.25,.25\n"
      "count(1)=2,count(2)=4,density(1)=1.,3.,young(1)=1.,1.,thickness(1)=.5,.25,strain='element'");
  ASSERT_EQ(built.errors(), Texts{});
  const Scene& scene = built.scene;
  ASSERT_EQ(scene.bodies.size(), 2u);
  EXPECT_EQ(scene.bodies[1].name, "membrane 2");
  EXPECT_EQ(scene.bodies[1].first, 2u);
  EXPECT_EQ(scene.points.x, (std::vector<double>{.25, .75, .25, .75, 1, 1}));
  EXPECT_EQ(scene.points.y, (std::vector<double>{.25, .25, 0, 0, .25, .75}));
  EXPECT_EQ(scene.points.mass, (std::vector<double>{.25, .25, .375, .375, .375, .375}));
}

TEST(Membranes, WhoseLastEndMeetsTheFirstAreClosed) {
  const std::string circle = "curve(1)='ellipse',xc(1)=.5,yc(1)=.5,a(1)=.4,b(1)=.2,count(1)=10\n";
  const Scene scene = membranes(circle + membrane_properties).scene;
  EXPECT_TRUE(scene.bodies.at(0).closed);
  EXPECT_NEAR(total(scene.points.volume), .01 * 1.9376896441095350, 1e-15);  // 4 a E(sqrt(3)/2) of a = .4, b = .2
  EXPECT_FALSE(membranes(circle + "to(1)=359.\n" + membrane_properties).scene.bodies.at(0).closed);
}

TEST(Membranes, PointsOfTheirOwnRadiusMakeRingsAboutAnAxis) {
  const std::string in = "cyl=1.,wl=5\n";
  const Scene line = one_line("count(1)=16", in).scene;
  for (std::size_t k = 0; k < 16; ++k) {
    EXPECT_NEAR(line.points.volume[k], .01 * .05 * 2 * pi * line.points.x[k], 1e-16);
  }
  // A flat disc: the rings of the middles add up to pi (R^2 - r^2) t exactly, pinned or not.
  EXPECT_NEAR(total(line.points.volume), pi * (.81 - .01) * .01, 1e-16);
  const Scene pinned = one_line("count(1)=16,pinned(1)='both',strain='element'", in).scene;
  EXPECT_NEAR(total(pinned.points.volume), pi * (.81 - .01) * .01, 1e-16);
}

/// A hemisphere of radius R: 2 pi R^2 t, the mid-point rule errs by (pi / n)^2 / 96.
TEST(Membranes, HemisphereAboutAnAxis) {
  double before = 0;
  for (const int n : {10, 20, 40}) {
    const Scene scene = membranes(std::string("curve(1)='arc',a(1)=.5,to(1)=90.\n") + membrane_properties +
                                      "count(1)=" + std::to_string(n),
                                  "cyl=1.,wl=5\n")
                            .scene;
    const double error = std::abs(total(scene.points.volume) / (.01 * 2 * pi * .25) - 1);
    EXPECT_NEAR(error, pi * pi / (96 * n * n), 1e-3 * error);
    EXPECT_TRUE(before == 0 || std::abs(std::log2(before / error) - 2) < 0.01);
    before = error;
  }
}

// Pins of the particle file's rows.

TEST(Pins, OfRowsOfAStringFile) {
  const std::string pins = "$points pinned(1)=.true.,.false.,.true. $\n";
  EXPECT_EQ(build(string_deck(pins + "$membrane strain='element' $\n")).scene.pinned, (std::vector<std::size_t>{0, 2}));
  const Built without = build(string_deck(pins));
  EXPECT_EQ(warnings(without), (Texts{"5:19: where strain is measured at points a pin holds its point alone, not the "
                                      "nodes around it, which carry the load"}));
  EXPECT_EQ(without.scene.pinned, (std::vector<std::size_t>{0, 2}));
}

TEST(Pins, OfRowsThatAreNotThereOrNoMembrane) {
  const std::string element = "$membrane strain='element' $\n";
  EXPECT_EQ(build(string_deck(element + "$points pinned(4)=.true. $\n")).errors(),
            (Texts{"6:19: pinned(4) counts rows of the particle file, which has 3"}));
  std::string solid = string_deck(element + "$points pinned(1)=.true. $\n");
  solid.replace(solid.find("3,3,3,8"), 7, "3,3,3,0");
  EXPECT_EQ(build(solid).errors(),
            (Texts{"6:19: a pin holds points of strings and membranes, and the particle file is none"}));
}

}  // namespace
}  // namespace tether::test
