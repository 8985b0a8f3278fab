// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/contact/pairs.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/numbers.hpp"
#include "grid/block_mesh.hpp"

namespace tether {
namespace {

/// Two squares with a gap of 0.1 between them.
Mesh two_squares() {
  std::vector<Block> blocks(2);
  for (std::size_t k = 0; k < 2; ++k) {
    const double left = 1.1 * static_cast<double>(k);
    const std::array<Vec<2>, 4> corners{{{left, 0}, {left + 1, 0}, {left + 1, 1}, {left, 1}}};
    for (std::size_t c = 0; c < 4; ++c) blocks[k].edges[c] = straight(corners[c], corners[(c + 1) % 4]);
    blocks[k].cells = {2, 3, 2};
  }
  std::vector<MeshFlaw> flaws;
  return mesh_of_blocks(blocks, ElementKind::quad4, flaws);
}

/// Two bodies press each other from both sides, so that each counts by half; an obstacle presses back alone.
TEST(ContactPairs, OfTwoBodiesCountByHalf) {
  const Mesh mesh = two_squares();
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
