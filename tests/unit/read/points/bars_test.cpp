// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/bars.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "unit/read/points/bars_support.hpp"

namespace tether {
namespace {

using scenes::add_string;
using scenes::fem_scene;
using scenes::row;

constexpr Membrane one_way{100, 0, true};
constexpr std::uint8_t holds_both = holds_x | holds_y;

TEST(Bars, JoinConsecutivePoints) {
  Scene scene = fem_scene(10);
  add_string(scene, one_way, row(2, 2, 0.6, 0.8, 4), 0.5, 0.1);
  add_string(scene, Membrane{30, 0, false}, row(2, 6, 0.5, 0, 2), 0.5, 0.1);
  const BarMesh mesh = bars_of(scene);
  ASSERT_EQ(mesh.bars.size(), 4U);
  EXPECT_EQ(mesh.bars[1].a, 1U);
  EXPECT_EQ(mesh.bars[1].b, 2U);
  EXPECT_EQ(mesh.bars[3].a, 4U);
  EXPECT_NEAR(mesh.bars[0].rest, 1, 1e-15);
  EXPECT_NEAR(mesh.bars[0].section, 0.5, 1e-15);
  EXPECT_NEAR(mesh.bars[3].section, 1, 1e-15);
  EXPECT_NEAR(mesh.bars[3].stiffness(), 60, 1e-12);
  EXPECT_TRUE(mesh.bars[0].one_way);
  EXPECT_FALSE(mesh.bars[3].one_way);
  EXPECT_TRUE(mesh.anchors.empty());
}

TEST(Bars, OfAClosedStringGoBackToItsFirstPoint) {
  Scene scene = fem_scene(10);
  add_string(scene, one_way, {{2, 2}, {5, 2}, {2, 6}}, 0.5, 0.1);
  scene.bodies[0].closed = true;
  const BarMesh mesh = bars_of(scene);
  ASSERT_EQ(mesh.bars.size(), 3U);
  EXPECT_EQ(mesh.bars[2].a, 2U);
  EXPECT_EQ(mesh.bars[2].b, 0U);
  EXPECT_EQ(mesh.bars[2].rest, 4);
  EXPECT_NEAR(mesh.bars[0].section, 0.5 * (0.5 / 3.5 + 0.5 / 4), 1e-15);  // of 3 between 4 and 5
}

TEST(Bars, HaveTheMeanSectionOfTheirPoints) {
  Scene scene = fem_scene(10);
  add_string(scene, one_way, {{2, 2}, {3, 2}, {6, 2}}, 0.6, 0.1);
  const BarMesh mesh = bars_of(scene);
  EXPECT_NEAR(mesh.bars[0].section, 0.5 * (0.6 + 0.3), 1e-15);  // volume over 1, and over (1 + 3)/2
  EXPECT_NEAR(mesh.bars[1].section, 0.5 * (0.3 + 0.2), 1e-15);
}

// The pinned end of a curve has half a piece's volume, that of a file a whole one.
TEST(Bars, APinnedEndHasTheSectionBesideIt) {
  for (const double volume : {0.25, 0.5}) {
    Scene scene = fem_scene(10);
    add_string(scene, one_way, row(2, 2, 1, 0, 4), 0.5, 0.1);
    scene.points.volume[0] = volume;
    scene.pinned = {0};
    const BarMesh mesh = bars_of(scene);
    for (const Bar& bar : mesh.bars) EXPECT_NEAR(bar.section, 0.5, 1e-15);
    EXPECT_EQ(mesh.held[0], holds_both);
    EXPECT_EQ(mesh.held[1], holds_none);
  }
}

TEST(Bars, StrainAtTheStartIsTheStressAlongThemOverE) {
  Scene scene = fem_scene(10);
  add_string(scene, one_way, row(2, 2, 0.6, 0.8, 3), 0.5, 0.1);
  PointSet& P = scene.points;
  P.sxx[0] = -20 * 0.36, P.syy[0] = -20 * 0.64, P.sxy[0] = -20 * 0.48;  // along
  P.sxx[2] = 20 * 0.64, P.syy[2] = 20 * 0.36, P.sxy[2] = -20 * 0.48;    // across
  const BarMesh mesh = bars_of(scene);
  EXPECT_NEAR(mesh.bars[0].strain, -0.1, 1e-15);
  EXPECT_NEAR(mesh.bars[1].strain, 0, 1e-15);
}

/// A string of spacing 1 that runs up towards a top wall, this far from its last point.
Scene under_a_wall(double distance, Wall wall, double dx = 0, double dy = 1) {
  Scene scene = fem_scene(10);
  scene.walls.top = wall;
  add_string(scene, one_way, row(5 - 2 * dx, 10 - distance - 2 * dy, dx, dy, 3), 0.5, 0.1);
  return scene;
}

TEST(BarsAtWalls, AnEndNearAFixedWallIsHeld) {
  for (const double distance : {0.0, 0.3, 0.39}) {
    const BarMesh mesh = bars_of(under_a_wall(distance, Wall::fixed));
    EXPECT_EQ(mesh.held[2], holds_both) << distance;
    EXPECT_EQ(mesh.bars.size(), 2U);
    ASSERT_EQ(mesh.wall_ends.size(), 1U);
    EXPECT_EQ(mesh.wall_ends[0].wall, "top");
    EXPECT_EQ(mesh.wall_ends[0].length, 0);
  }
}

TEST(BarsAtWalls, AnEndFartherAwayIsJoinedByABar) {
  Scene scene = under_a_wall(0.5, Wall::fixed);
  scene.points.syy[2] = 10;
  const BarMesh mesh = bars_of(scene);
  EXPECT_EQ(mesh.held[2], holds_none);
  ASSERT_EQ(mesh.bars.size(), 3U);
  EXPECT_EQ(mesh.bars[2].a, 2U);
  EXPECT_EQ(mesh.bars[2].b, 3U);
  EXPECT_NEAR(mesh.bars[2].rest, 0.5, 1e-14);
  EXPECT_NEAR(mesh.bars[2].section, 0.5, 1e-14);
  EXPECT_NEAR(mesh.bars[2].strain, 0.1, 1e-15);
  ASSERT_EQ(mesh.anchors.size(), 1U);
  EXPECT_EQ(mesh.anchors[0].slides, holds_none);
  EXPECT_EQ(mesh.anchors[0].y, 10);
}

TEST(BarsAtWalls, ABarGoesStraightOnToAFixedWall) {
  const BarMesh mesh = bars_of(under_a_wall(0.4, Wall::fixed, 0.6, 0.8));  // half a spacing along the string
  ASSERT_EQ(mesh.anchors.size(), 1U);
  EXPECT_NEAR(mesh.anchors[0].x, 5.3, 1e-14);
  EXPECT_NEAR(mesh.bars[2].rest, 0.5, 1e-14);
}

TEST(BarsAtWalls, AtAWallThatHoldsOneComponentTheEndSlides) {
  EXPECT_EQ(bars_of(under_a_wall(0.3, Wall::symmetry)).held[2], holds_y);
  const BarMesh mesh = bars_of(under_a_wall(0.6, Wall::free_slip, 0.6, 0.8));
  ASSERT_EQ(mesh.anchors.size(), 1U);
  EXPECT_EQ(mesh.anchors[0].slides, holds_x);
  EXPECT_EQ(mesh.anchors[0].x, 5);
  EXPECT_NEAR(mesh.bars[2].rest, 0.6, 1e-14);
}

TEST(BarsAtWalls, NothingElseIsJoined) {
  EXPECT_TRUE(bars_of(under_a_wall(1.01, Wall::fixed)).wall_ends.empty());           // too far away
  EXPECT_TRUE(bars_of(under_a_wall(0.2, Wall::open)).wall_ends.empty());             // no wall
  EXPECT_TRUE(bars_of(under_a_wall(0.2, Wall::fixed, 1, 0)).wall_ends.empty());      // runs along it
  EXPECT_TRUE(bars_of(under_a_wall(0.5, Wall::fixed, 0.9, 0.4)).wall_ends.empty());  // meets it farther on
  Scene pinned = under_a_wall(0.2, Wall::fixed), closed = under_a_wall(0.2, Wall::fixed);
  pinned.pinned = {2};
  closed.bodies[0].closed = true;
  EXPECT_TRUE(bars_of(pinned).wall_ends.empty());
  EXPECT_TRUE(bars_of(closed).wall_ends.empty());
}

TEST(HighestFrequency, OfOneBarAloneIsExact) {
  Scene scene = fem_scene(10);
  add_string(scene, one_way, row(2, 2, 0.5, 0, 2), 0.5, 0.1);
  scene.points.mass[1] = 0.4;
  const double k = 100 * 1 / 0.5;
  EXPECT_NEAR(highest_frequency(scene, bars_of(scene)), std::sqrt(k * (1 / 0.1 + 1 / 0.4)), 1e-11);
  scene.pinned = {0};
  EXPECT_NEAR(highest_frequency(scene, bars_of(scene)), std::sqrt(k / 0.4), 1e-11);
  scene.pinned = {0, 1};
  EXPECT_EQ(highest_frequency(scene, bars_of(scene)), 0);
}

/// The highest one of a straight string by the power method.
double highest_by_iteration(const Scene& scene, const BarMesh& mesh) {
  std::vector<double> u(scene.points.size()), f(u.size());
  for (std::size_t p = 0; p < u.size(); ++p) u[p] = p % 2 == 0 ? 1 : -1.3;
  double squared = 0;
  for (int round = 0; round < 20000; ++round) {
    std::fill(f.begin(), f.end(), 0.0);
    for (const Bar& bar : mesh.bars) {
      const double pull = bar.stiffness() * (u[bar.a] - u[bar.b]);
      f[bar.a] += pull, f[bar.b] -= pull;
    }
    double largest = 0;
    for (std::size_t p = 0; p < u.size(); ++p) {
      u[p] = mesh.held[p] == holds_none ? f[p] / scene.points.mass[p] : 0;
      largest = std::max(largest, std::abs(u[p]));
    }
    for (double& value : u) value /= largest;
    squared = largest;
  }
  return std::sqrt(squared);
}

TEST(HighestFrequency, OfAChainIsItsLimitForManyPoints) {
  Scene scene = fem_scene(30);
  add_string(scene, one_way, row(2, 2, 0.5, 0, 40), 0.5, 0.1);
  const BarMesh mesh = bars_of(scene);
  const double k = 200, bound = highest_frequency(scene, mesh);
  EXPECT_NEAR(bound, 2 * std::sqrt(k / 0.1), 1e-9);
  const double exact = bound * std::cos(std::numbers::pi / 80);  // 2 sqrt(k/m) sin(39 pi / 80)
  EXPECT_NEAR(highest_by_iteration(scene, mesh), exact, 1e-3 * exact);
}

TEST(HighestFrequency, IsABoundOfAnyChain) {
  for (int seed = 1; seed < 20; ++seed) {
    Scene scene = fem_scene(30);
    std::vector<std::pair<double, double>> places{{1, 1}};
    for (int k = 1; k < 12; ++k) places.emplace_back(places.back().first + 0.2 + std::abs(std::sin(7.0 * k * seed)), 1);
    add_string(scene, one_way, places, 0.5, 0.1);
    for (std::size_t p = 0; p < places.size(); ++p)
      scene.points.mass[p] = std::exp(2 * std::sin(3.0 * seed * static_cast<double>(p)));
    scene.pinned = {static_cast<std::size_t>(seed) % 12};
    const BarMesh mesh = bars_of(scene);
    const double exact = highest_by_iteration(scene, mesh), bound = highest_frequency(scene, mesh);
    EXPECT_GE(bound, exact * (1 - 1e-9)) << seed;
    EXPECT_LE(bound, 1.5 * exact) << seed;
  }
}

// Across a bar that is stretched at the start by more than its length, the tension over the length is the stiffer.
TEST(HighestFrequency, CountsATensionAboveE) {
  Scene scene = fem_scene(10);
  add_string(scene, one_way, row(2, 2, 0.5, 0, 2), 0.5, 0.1);
  scene.points.sxx = {400, 400};
  EXPECT_NEAR(highest_frequency(scene, bars_of(scene)), std::sqrt(4 * 200 * 2 / 0.1), 1e-10);
}

}  // namespace
}  // namespace tether
