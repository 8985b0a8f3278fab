// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "base/diagnostics.hpp"
#include "unit/physics/box/mesh_support.hpp"

// Into which rooms bodies part a fluid on triangles.

namespace tether::coupled {
namespace {

using support::Flowing, support::box_of;

/// Four bars that cross shut in a square of fluid, which is left out where it is small: nothing could leave it.
TEST(MeshFlow, SmallRoomsBetweenBodiesThatCrossAreLeftOut) {
  for (const double wide : {0.06, 0.1}) {
    const auto bar = [](const Vec<3>& middle, const Vec<3>& sides) {
      return support::lattice(2, {2, 2, 1}, support::all, support::turned_block(middle, sides, 0));
    };
    const double off = 0.5 * wide + 0.05;
    const Mesh bars = support::together(
        support::together(bar({0.5 - off, 0.51, 0}, {0.1, 0.8, 0}), bar({0.5 + off, 0.49, 0}, {0.1, 0.8, 0})),
        support::together(bar({0.51, 0.5 - off, 0}, {0.8, 0.1, 0}), bar({0.49, 0.5 + off, 0}, {0.8, 0.1, 0})));
    const Flowing flowing(box_of(0.08), bars);
    EXPECT_EQ(flowing.flow.regions().count, wide > 0.08 ? 2 : 1);
    double volume = 0;
    for (const double of_cell : flowing.mesh().volume) volume += of_cell;
    EXPECT_NEAR(volume, 1 - 4 * 0.08 + 4 * 0.01 - (wide > 0.08 ? 0 : wide * wide), 1e-3);
  }
}

/// A square whose outline a node has crossed: the loop that it makes turns the other way round, and the fluid about it
/// is still there.
TEST(MeshFlow, ABodyThatCrossesItselfLeavesTheFluidAround) {
  const Mesh body = support::lattice(2, {2, 2, 1}, support::all, [](const Vec<3>& s) {
    if (s[0] == 0 && s[1] == 0.5) return Vec<3>{0.32, 0.75, 0};
    return Vec<3>{0.3 + 0.4 * s[0], 0.3 + 0.4 * s[1], 0};
  });
  const Flowing flowing(box_of(0.07), body);
  EXPECT_EQ(flowing.flow.regions().count, 1);
  double volume = 0;
  for (const double of_cell : flowing.mesh().volume) volume += of_cell;
  const double cut = 0.02 * 0.4 / 0.45;  // of the upper side
  EXPECT_NEAR(volume, 1 - 0.4 * (0.4 - 0.5 * cut) - 0.5 * cut * 0.05, 1e-12);
}

/// Fluid in cavities alone, of which the body has none.
TEST(MeshFlow, WithoutACellIsAnError) {
  const Mesh body = support::lattice(2, {2, 2, 1}, support::all, [](const Vec<3>& s) {
    return Vec<3>{0.3 + 0.4 * s[0], 0.3 + 0.4 * s[1], 0};
  });
  Coupled scene = box_of(0.07);
  scene.cavities_only = true;
  EXPECT_THROW(Flowing(scene, body), RunError);
}

/// A body that reaches from wall to wall parts the fluid; one that lies on a wall has a film beneath.
TEST(MeshFlow, BodiesFromWallToWallAreTight) {
  for (const double high : {1.0, 0.6}) {
    const Mesh body = support::lattice(2, {2, 6, 1}, support::all, [&](const Vec<3>& s) {
      return Vec<3>{0.4 + 0.2 * s[0], high * s[1], 0};
    });
    Flowing flowing(box_of(0.07), body);
    EXPECT_EQ(flowing.flow.regions().count, high == 1 ? 2 : 1);
    flowing.set([](const Vec<3>&) { return Vec<3>{1, 0, 0}; });
    flowing.project();
    if (high == 1) {
      EXPECT_LT(flowing.error([](const Vec<3>&) { return Vec<3>{}; }), 1e-10);
    }
    for (std::size_t f = 0; f < flowing.mesh().faces(); ++f)
      EXPECT_EQ(flowing.mesh().is_at_boundary(f), flowing.mesh().boundary[f].kind != BoundaryKind::none);
  }
}

}  // namespace
}  // namespace tether::coupled
