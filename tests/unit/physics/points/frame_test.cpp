// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/points/frame.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "grid/kernels.hpp"
#include "physics/points/arrays.hpp"
#include "unit/physics/points/robust_support.hpp"

namespace tether::mpm {
namespace {

using scenes::all_walls;
using std::numbers::pi;

const BackgroundGrid cells_of_half_by_quarter(9, 13, 1, 5, -1, 2);  // 8 x 12 cells

std::size_t node(const Frame& frame, int i, int j) {  // of the deck's grid
  return frame.of_deck(static_cast<std::size_t>(j) * static_cast<std::size_t>(frame.deck.nx) +
                       static_cast<std::size_t>(i));
}
double volume(const Frame& frame, int i, int j) { return 1 / frame.per_volume[node(frame, i, j)]; }

/// Of all nodes that are nobody's ghost.
double whole_volume(const Frame& frame) {
  double sum = 0;
  for (std::size_t n = 0; n < frame.image.size(); ++n) sum += frame.image[n] == n ? 1 / frame.per_volume[n] : 0;
  return sum;
}

class EveryKernel : public testing::TestWithParam<Kernel> {};
INSTANTIATE_TEST_SUITE_P(Kernels, EveryKernel, testing::Values(Kernel::linear, Kernel::bspline));

TEST_P(EveryKernel, NodesShareTheScenesVolume) {
  for (const Wall wall : {Wall::fixed, Wall::symmetry, Wall::axis, Wall::free_slip}) {
    const Frame plane(cells_of_half_by_quarter, all_walls(wall), Geometry::plane, GetParam());
    EXPECT_NEAR(whole_volume(plane), 4 * 3, 1e-12);
    const Frame ring(cells_of_half_by_quarter, all_walls(wall), Geometry::axisymmetric, GetParam());
    EXPECT_NEAR(whole_volume(ring), pi * (25 - 1) * 3, 1e-11);
    const Frame on_axis(BackgroundGrid(9, 13, 0, 4, -1, 2), all_walls(wall), Geometry::axisymmetric, GetParam());
    EXPECT_NEAR(whole_volume(on_axis), pi * 16 * 3, 1e-11);
  }
}

TEST_P(EveryKernel, AWallsNodeHasHalfACellAndACornersAQuarter) {
  for (const Wall wall : {Wall::fixed, Wall::symmetry, Wall::axis, Wall::free_slip}) {
    const Frame frame(cells_of_half_by_quarter, all_walls(wall), Geometry::plane, GetParam());
    const double cell = 0.5 * 0.25;
    EXPECT_NEAR(volume(frame, 4, 5), cell, 1e-15);
    EXPECT_NEAR(volume(frame, 1, 5), cell, 1e-15);  // beside a wall: what it gives to it, it gets back
    for (const int i : {0, 8}) EXPECT_NEAR(volume(frame, i, 5), 0.5 * cell, 1e-15);
    for (const int j : {0, 12}) EXPECT_NEAR(volume(frame, 4, j), 0.5 * cell, 1e-15);
    for (const int i : {0, 8}) {
      for (const int j : {0, 12}) EXPECT_NEAR(volume(frame, i, j), 0.25 * cell, 1e-15);
    }
  }
}

// int N_i 2 pi r dr: in the open 2 pi r_i h, on the axis 2 pi times 13/64 h^2 by splines, h^2/6 by bilinear functions.
TEST_P(EveryKernel, VolumesAboutAnAxis) {
  const Frame frame(BackgroundGrid(9, 13, 0, 4, -1, 2), {Wall::axis, Wall::open, Wall::symmetry, Wall::symmetry},
                    Geometry::axisymmetric, GetParam());
  const double h = 0.5, dz = 0.25;
  EXPECT_NEAR(volume(frame, 5, 4), 2 * pi * 2.5 * h * dz, 1e-13);
  const double at_axis = GetParam() == Kernel::bspline ? 13.0 / 64 : 1.0 / 6;
  EXPECT_NEAR(volume(frame, 0, 4), 2 * pi * at_axis * h * h * dz, 1e-14);
  EXPECT_NEAR(volume(frame, 0, 0), pi * at_axis * h * h * dz, 1e-14);
}

TEST(Frame, AnOpenEdgeHasRoomOfSixCells) {
  const Frame open(cells_of_half_by_quarter, all_walls(Wall::open), Geometry::plane, Kernel::bspline);
  EXPECT_EQ(open.shape.nx, 9 + 14);
  EXPECT_EQ(open.shape.ny, 13 + 14);
  EXPECT_TRUE(open.ghosts.empty());
  for (const int i : {-5, 0, 4, 8, 13}) {
    const std::size_t n = node(open, 0, 5) + static_cast<std::size_t>(i + 5) - 5;
    EXPECT_NEAR(1 / open.per_volume[n], 0.125, 1e-15) << i;
  }
  EXPECT_TRUE(open.contains(1 - 2.99, -1 - 1.49));
  EXPECT_TRUE(open.contains(5 + 2.99, 2 + 1.49));
  EXPECT_FALSE(open.contains(1 - 3.01, 0));
  EXPECT_FALSE(open.contains(3, 2 + 1.51));
  const Locator locator(open.shape);
  for (const double x : {open.x0, open.x1}) {  // the last places of all have nodes
    for (const std::size_t n : SplineKernel::nodes(locator, SplineKernel::locate(locator, x, open.y1)))
      EXPECT_LT(n, open.shape.nodes());
  }
}

TEST(Frame, WallsAndBilinearFunctionsNeedNoRoom) {
  const Frame walls(cells_of_half_by_quarter, all_walls(Wall::fixed), Geometry::plane, Kernel::bspline);
  EXPECT_EQ(walls.shape.nx, 9 + 2);
  EXPECT_FALSE(walls.contains(0.999, 0));
  EXPECT_TRUE(walls.contains(1, 2));
  EXPECT_FALSE(walls.contains(std::nan(""), 0));
  const Frame linear(cells_of_half_by_quarter, all_walls(Wall::open), Geometry::plane, Kernel::linear);
  EXPECT_EQ(linear.shape, linear.deck);
  EXPECT_TRUE(linear.ghosts.empty());
  EXPECT_FALSE(linear.contains(0.999, 0));
}

// Room behind an open edge ends at the axis: a ring has a radius.
TEST(Frame, RoomEndsAtTheAxis) {
  const Frame frame(cells_of_half_by_quarter, all_walls(Wall::open), Geometry::axisymmetric, Kernel::bspline);
  EXPECT_FALSE(frame.contains(-0.01, 0));
  EXPECT_TRUE(frame.contains(0.01, 0));
  for (const double per_volume : frame.per_volume) {
    EXPECT_GT(per_volume, 0);
    EXPECT_TRUE(std::isfinite(per_volume));
  }
}

TEST(Frame, SignsOfGhosts) {
  const Walls walls{Wall::symmetry, Wall::fixed, Wall::axis, Wall::free_slip};
  const Frame frame(cells_of_half_by_quarter, walls, Geometry::plane, Kernel::bspline);
  const auto expect = [&](int i, int j, int image_i, int image_j, double sx, double sy) {
    const std::size_t n = node(frame, 4, 4) + static_cast<std::size_t>((j + 1) * frame.shape.nx + i + 1) -
                          static_cast<std::size_t>(5 * frame.shape.nx + 5);
    EXPECT_EQ(frame.image[n], node(frame, image_i, image_j));
    EXPECT_EQ(frame.sign[n].x, sx);
    EXPECT_EQ(frame.sign[n].y, sy);
  };
  expect(-1, 5, 1, 5, -1, 1);
  expect(9, 5, 7, 5, -1, -1);
  expect(4, -1, 4, 1, 1, -1);
  expect(4, 13, 4, 11, 1, -1);
  expect(-1, -1, 1, 1, -1, -1);
  expect(9, 13, 7, 11, -1, 1);  // behind the fixed wall all is odd, behind the upper one its normal component again
  EXPECT_EQ(frame.ghosts.size(), 11U * 15U - 9U * 13U);
}

TEST(Frame, WallsHoldTheNodesOnThem) {
  const Walls walls{Wall::symmetry, Wall::fixed, Wall::open, Wall::free_slip};
  const Frame frame(cells_of_half_by_quarter, walls, Geometry::plane, Kernel::bspline);
  EXPECT_EQ(frame.held[node(frame, 0, 5)], holds_x);
  EXPECT_EQ(frame.held[node(frame, 8, 5)], holds_x | holds_y);
  EXPECT_EQ(frame.held[node(frame, 4, 0)], holds_none);
  EXPECT_EQ(frame.held[node(frame, 4, 12)], holds_y);
  EXPECT_EQ(frame.held[node(frame, 0, 12)], holds_x | holds_y);
  EXPECT_EQ(frame.held[node(frame, 4, 5)], holds_none);
}

class Folding : public testing::Test {
 protected:
  Folding() {
    Scene scene =
        scenes::scene_on(cells_of_half_by_quarter, {Wall::symmetry, Wall::fixed, Wall::axis, Wall::free_slip}, 1, {});
    scene.method.kernel = Kernel::bspline;
    scene.method.ledger = true;
    scene.bodies.push_back({.name = "gas", .material = scenes::robust_gas()});
    grid_ = std::make_unique<Grid>(scene, instruction_set());
  }
  Pair any() { return pair(spread_(random_), spread_(random_)); }
  std::mt19937 random_{3};
  std::uniform_real_distribution<double> spread_{-1, 1};
  std::unique_ptr<Grid> grid_;
};

// What points get out of a ghosts' fields is what they put in: the fold of one field times another at the nodes is the
// first times the other's values at nodes and ghosts. Momentum and energy at walls rest on it.
TEST_F(Folding, IsTheTransposeOfUnfolding) {
  const std::size_t n = grid_->frame.shape.nodes();
  std::vector<Pair> given(n), field(n);
  std::vector<double> masses(n), values(n);
  for (std::size_t k = 0; k < n; ++k) {
    given[k] = any(), field[k] = any(), masses[k] = spread_(random_), values[k] = spread_(random_);
    grid_->sums[k] = NodeSums{given[k], any(), masses[k], masses[k]};
    grid_->motion[k] = NodeMotion{any(), field[k]};
    grid_->gas.rho[k] = grid_->gas.heat[k] = values[k];
    grid_->squares[k] = values[k];
  }
  grid_->unfold_motion(), grid_->unfold_gas(), grid_->unfold_squares();
  double before = 0, mass_before = 0, gas_before = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const Pair work = given[k] * Pair(grid_->motion.u[k]);
    before += work[0] + work[1];
    mass_before += masses[k] * grid_->squares[k], gas_before += masses[k] * grid_->gas.heat[k];
  }
  grid_->fold_sums();
  double after = 0, mass_after = 0, gas_after = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const Pair work = Pair(grid_->sums.momentum[k]) * field[k];
    after += work[0] + work[1];
    mass_after += grid_->sums.m[k] * values[k], gas_after += grid_->sums.gas[k] * values[k];
  }
  EXPECT_NEAR(after, before, 1e-13);
  EXPECT_NEAR(mass_after, mass_before, 1e-13);
  EXPECT_NEAR(gas_after, gas_before, 1e-13);
}

TEST_F(Folding, LeavesGhostsEmptyAndUnfoldingGivesTheImagesBack) {
  for (std::size_t n = 0; n < grid_->convected.size(); ++n) grid_->convected[n] = any();
  const auto given = grid_->convected;
  grid_->fold_convected();
  for (const Ghost& ghost : grid_->frame.ghosts) {
    EXPECT_EQ(grid_->convected[static_cast<std::size_t>(ghost.node)][0], 0);
    EXPECT_EQ(grid_->convected[static_cast<std::size_t>(ghost.node)][1], 0);
  }
  // Beside the left wall: its own and the ghost's with the normal component turned round.
  const std::size_t image = node(grid_->frame, 1, 5), ghost = image - 2;
  EXPECT_EQ(grid_->convected[image][0], given[image][0] - given[ghost][0]);
  EXPECT_EQ(grid_->convected[image][1], given[image][1] + given[ghost][1]);
  const auto folded = grid_->convected;
  grid_->unfold_convected();
  EXPECT_EQ(grid_->convected[ghost][0], -folded[image][0]);
  EXPECT_EQ(grid_->convected[ghost][1], folded[image][1]);
}

// A mirror-symmetric field of points on either side of a wall is, folded, twice that of one side's.
TEST_F(Folding, AMirroredPointGivesWhatItsImageGives) {
  Grid& grid = *grid_;
  const Frame& frame = grid.frame;
  const Locator locator(frame.shape);
  const auto put = [&](double x, double y, Pair momentum, NodeSumsRow& sums) {
    const auto at = SplineKernel::locate(locator, x, y);
    const auto N = SplineKernel::values(at);
    const auto nodes = SplineKernel::nodes(locator, at);
    for (std::size_t k = 0; k < SplineKernel::size; ++k)
      sums.m[nodes[k]] += N[k], sums.momentum[nodes[k]] += N[k] * momentum;
  };
  NodeSumsRow own(frame.shape.nodes()), both = own;
  put(1.1, 0.4, pair(0.3, 0.7), own);
  put(1.1, 0.4, pair(0.3, 0.7), both), put(0.9, 0.4, pair(-0.3, 0.7), both);
  fold_sums(frame.ghosts, own);
  for (std::size_t n = 0; n < own.size(); ++n) {
    const bool on_wall = (frame.held[n] & holds_x) != 0;
    if (frame.image[n] != n) continue;
    // Beside the wall the nodes behind it do the folding; on it the two sides stand as they are.
    EXPECT_NEAR(both[n].m, (on_wall ? 2 : 1) * own[n].m, 1e-15);
    EXPECT_NEAR(both[n].momentum[0], on_wall ? 0 : own[n].momentum[0], 1e-15);
    EXPECT_NEAR(both[n].momentum[1], (on_wall ? 2 : 1) * own[n].momentum[1], 1e-15);
  }
}

}  // namespace
}  // namespace tether::mpm
