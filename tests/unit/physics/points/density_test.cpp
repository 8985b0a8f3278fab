// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/points/density.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "physics/points/state.hpp"
#include "unit/physics/scenes.hpp"

namespace tether::mpm {
namespace {

using scenes::add_block;
using scenes::open_scene;

Scene filled_box(DensityRule rule, Wall wall, int per_side) {
  Scene scene = open_scene(6, 5);
  scene.walls = {wall, wall, wall, wall};
  add_block(scene, IdealGas{.rule = rule}, 0, 5, 0, 4, per_side, 3.0, 2.0);
  return scene;
}

// Evenly filled, and mirrored at its walls, a box has its own density everywhere.
TEST(CellDensity, AnEvenBoxBetweenMirrors) {
  for (const auto rule : {DensityRule::cell, DensityRule::quadratic, DensityRule::continuity}) {
    for (const auto wall : {Wall::symmetry, Wall::axis, Wall::free_slip}) {
      const State state = start(filled_box(rule, wall, 3));
      for_points(state.points, {0, state.points.size()}, [&](std::size_t p) {
        EXPECT_NEAR(state.points.rho[p], 3, 1e-12);
        EXPECT_NEAR(state.points.sxx[p], -0.4 * 3 * 2, 1e-12);
      });
    }
  }
}

// Without a mirror an edge cell lacks what lies behind it: its middle point gives it .75, its neighbour .125.
TEST(CellDensity, AnOpenEdgeHasNothingBehindIt) {
  const State state = start(filled_box(DensityRule::quadratic, Wall::open, 1));
  const double one_axis = 0.75 + 0.125;
  for (std::size_t p = 0; p < state.points.size(); ++p) {
    const bool edge_x = state.points.x[p] < 1 || state.points.x[p] > 4,
               edge_y = state.points.y[p] < 1 || state.points.y[p] > 3;
    EXPECT_NEAR(state.points.rho[p], 3 * (edge_x ? one_axis : 1) * (edge_y ? one_axis : 1), 1e-12);
  }
}

TEST(CellDensity, QuadraticSpreadsOnePointOverNineCells) {
  Scene scene = open_scene(6, 6);
  add_block(scene, IdealGas{.rule = DensityRule::quadratic}, 2, 3, 2, 3, 1, 1.0, 1.0);
  scene.points.x[0] = 2.5 + 0.2, scene.points.y[0] = 2.5 - 0.1;
  const State state = start(scene);
  const double x[] = {0.5 * 0.3 * 0.3, 0.75 - 0.04, 0.5 * 0.7 * 0.7},
               y[] = {0.5 * 0.6 * 0.6, 0.75 - 0.01, 0.5 * 0.4 * 0.4};
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR((*state.density)(1 + i, 1 + j), x[i] * y[j], 1e-14);
  }
}

TEST(CellDensity, AllGasOfACellCountsWhateverItsBody) {
  Scene scene = open_scene(4, 4);
  add_block(scene, IdealGas{.rule = DensityRule::cell}, 1, 2, 1, 2, 1, 1.0, 1.0);
  add_block(scene, IdealGas{.rule = DensityRule::cell}, 1, 2, 1, 2, 2, 5.0, 1.0);
  const State state = start(scene);
  for (const double rho : state.points.rho) EXPECT_NEAR(rho, 6, 1e-14);
}

TEST(CellDensity, ForgetsWherePointsWere) {
  Scene scene = open_scene(9, 9);
  add_block(scene, IdealGas{.rule = DensityRule::quadratic}, 2, 3, 2, 3, 1, 1.0, 1.0);
  State state = start(scene);
  state.points.x[0] = 3.5;
  state.density->update(state.points, state.gas, state.gas_by_cells);
  EXPECT_NEAR(state.points.rho[0], 0.75 * 0.75, 1e-14);
  EXPECT_NEAR((*state.density)(2, 2), 0.125 * 0.75, 1e-14);
}

}  // namespace
}  // namespace tether::mpm
