// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/contact/pairs.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "unit/grid/mesh_support.hpp"

namespace tether {
namespace {

/// Two bodies press each other from both sides, so that each counts by half; an obstacle presses back alone.
TEST(ContactPairs, OfTwoBodiesCountByHalf) {
  const Mesh mesh = meshed({block_between(0, 1), block_between(1.1, 2.1)}, ElementKind::quad4);
  const ContactSurface surface = contact_surface(mesh, {}, {{{2.2, 0, 0}, {3, 1, 1}}});
  std::vector<double> x(surface.places.size() * 2, 0.0);
  surface.places.find(mesh.x, x);
  Team team;
  ContactPairs pairs(surface, {}, team);
  pairs.find({x}, 0.11, 0);
  int of_bodies = 0, of_obstacles = 0;
  for (const ContactPair& pair : pairs.pairs()) {
    if (pair.guard || pair.kind != PairKind::edge || pair.side < 0) continue;
    const double area = surface.points[pair.point].area;
    EXPECT_DOUBLE_EQ(pair.area, pair.other < 0 ? area : 0.5 * area);
    ++(pair.other < 0 ? of_obstacles : of_bodies);
  }
  EXPECT_GT(of_bodies, 0);
  EXPECT_GT(of_obstacles, 0);
}

}  // namespace
}  // namespace tether
