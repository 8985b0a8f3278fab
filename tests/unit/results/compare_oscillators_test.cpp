// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "reference/oscillators.hpp"
#include "unit/results/compare_support.hpp"

namespace tether::test {
namespace {

using std::numbers::pi;

double nowhere(double) { return 1; }

/// k = 8/3, m = 2, g = 10, and three halves of the .001 of a point that stands for 1/2, of the hanging string.
const SpringMass spring{2, 8.0 / 3, 10, 0.003};
/// Of what the spring's own mass adds to the static stretch, 3/4 of a thousandth.
constexpr double own = 1 + 0.003 / 2 / 2;

/// The exact motion, 400 samples a period for two periods and a bit, stretched in time and in height.
Comparison spring_comparison(double slower, double higher) {
  const auto y = [&](double t) { return 1.5 + higher * spring.position(t / slower); };
  return compare(hanging_string(ReferenceKind::spring), history_of(slower * spring.period() / 400, 810, nowhere, y),
                 {});
}

TEST(CompareSpring, TheExactMotionHasNoError) {
  const Comparison comparison = spring_comparison(1, 1);
  ASSERT_EQ(comparison.merits.size(), 2u);
  const Merit& period = merit_of(comparison, "period");
  EXPECT_NEAR(period.exact, 2 * pi * std::sqrt(0.75 * (1 + 0.0015 / 3)), 1e-6);
  EXPECT_NEAR(period.error, 0, 1e-5);  // its higher modes move the passages by a part of the mass
  EXPECT_FALSE(period.profile);
  const Merit& drop = merit_of(comparison, "largest_drop");
  EXPECT_NEAR(drop.exact, 15 * own, 2e-4);  // 2 (m + M_s/2) g / k, but for its higher modes
  EXPECT_NEAR(drop.error, 0, 1e-5);
}

TEST(CompareSpring, AStretchedMotionHasTheErrorOfTheStretch) {
  const Comparison comparison = spring_comparison(1.01, 0.98);
  EXPECT_NEAR(merit_of(comparison, "period").error, 0.01, 1e-5);
  EXPECT_NEAR(merit_of(comparison, "largest_drop").error, -0.02, 1e-5);
}

TEST(CompareSpring, TabulatesTheExactMotionAtTheTimesOfTheHistory) {
  const Comparison comparison = spring_comparison(1, 1.5);
  EXPECT_EQ(comparison.exact.names, (std::vector<std::string>{"time", "point_y_2"}));
  ASSERT_EQ(comparison.exact.columns.size(), 2u);
  ASSERT_EQ(comparison.exact.columns[1].size(), 811u);
  EXPECT_EQ(comparison.exact.columns[1][0], 1.5);
  EXPECT_NEAR(comparison.exact.columns[0][200], spring.period() / 2, 1e-15);
  EXPECT_NEAR(comparison.exact.columns[1][200], 1.5 - 15 * own, 2e-4);
}

/// The spring reaches on to the wall that holds it, a quarter above its first point: L = 7/4 and k = E A/L = 16/7.
TEST(CompareSpring, ReachesToTheWall) {
  Scene scene = hanging_string(ReferenceKind::spring);
  scene.grid = BackgroundGrid(3, 8, 0, 2, -0.25, 3.25);
  scene.walls.top = Wall::fixed;
  const auto period_of = [&] {
    const History still = history_of(1, 4, nowhere, [](double) { return 1.5; });
    return merit_of(compare(scene, still, {}), "period").exact;
  };
  EXPECT_NEAR(period_of(), (SpringMass{2, 16.0 / 7, 10, 0.0035}.period()), 1e-12);
  scene.pinned = {0};  // it begins at the pin
  EXPECT_NEAR(period_of(), spring.period(), 1e-12);
  scene.pinned = {};
  scene.walls.top = Wall::free_slip;  // holds what goes up and down as well
  EXPECT_NEAR(period_of(), (SpringMass{2, 16.0 / 7, 10, 0.0035}.period()), 1e-12);
}

TEST(CompareSpring, NotANumberWhereTheRunIsTooShort) {
  const auto y = [](double t) { return 1.5 + spring.position(t); };
  const Comparison quarter =
      compare(hanging_string(ReferenceKind::spring), history_of(spring.period() / 400, 100, nowhere, y), {});
  EXPECT_TRUE(std::isnan(merit_of(quarter, "period").error));
  EXPECT_TRUE(std::isnan(merit_of(quarter, "largest_drop").error));
}

/// Two of the four points begin under -1 and -.6, which E = 8 makes strains of -1/8 and -.075: a slack of 1/2 (.2).
Scene slack_string() {
  Scene scene = hanging_string(ReferenceKind::string);
  scene.points.syy[1] = -1;
  scene.points.sxx[2] = -0.6;
  scene.points.syy[3] = 4;  // tension is no slack
  return scene;
}

const StringBounce bounce{2, 8.0 / 3, 10, 0.1};

Comparison string_comparison(double slower, double higher) {
  const auto y = [&](double t) { return 1.5 + higher * bounce.position(t / slower); };
  return compare(slack_string(), history_of(slower * bounce.apex_time() / 20000, 30000, nowhere, y), {});
}

/// Linear interpolation between samples h = 2.7e-4 apart is late or early by g h^2 / (8 v) at most, v = sqrt(2 g s) =
/// 1.4 the speed at the passage: 6.5e-8, where the taut time is .14.
constexpr double interpolation = 5e-7;

TEST(CompareString, TheExactMotionHasNoError) {
  const Comparison comparison = string_comparison(1, 1);
  ASSERT_EQ(comparison.merits.size(), 4u);
  EXPECT_NEAR(merit_of(comparison, "taut_time").exact, std::sqrt(0.02), 1e-15);
  EXPECT_NEAR(merit_of(comparison, "largest_drop").exact, 7.6 + std::hypot(7.5, std::sqrt(1.5)), 1e-13);
  for (const Merit& merit : comparison.merits) EXPECT_NEAR(merit.error, 0, interpolation) << merit.name;
}

TEST(CompareString, ASlowerMotionIsLateByAsMuch) {
  const Comparison comparison = string_comparison(1.02, 1);
  for (const char* name : {"taut_time", "slack_again_time", "apex_time"}) {
    EXPECT_NEAR(merit_of(comparison, name).error, 0.02, interpolation) << name;
  }
  EXPECT_NEAR(merit_of(comparison, "largest_drop").error, 0, 1e-9);
}

TEST(CompareString, ADeeperMotionHasTheErrorOfItsDepth) {
  EXPECT_NEAR(merit_of(string_comparison(1, 1.05), "largest_drop").error, 0.05, 1e-9);
}

TEST(CompareString, NotANumberWhereTheRunIsTooShort) {
  const auto y = [](double t) { return 1.5 + bounce.position(t); };
  const double fall = bounce.taut_time() / 100;
  const Comparison falling = compare(slack_string(), history_of(fall, 90, nowhere, y), {});
  for (const Merit& merit : falling.merits) EXPECT_TRUE(std::isnan(merit.error)) << merit.name;
}

/// From (1, 3) to (2.2, 1.4): length 2, held at atan(3/4) from the vertical.
Scene pendulum_scene() {
  Scene scene = hanging_string(ReferenceKind::pendulum);
  scene.bodies[0].material = Membrane{8e12, 0, false};  // it does not stretch
  for (int k = 0; k < 4; ++k) {
    const auto p = static_cast<std::size_t>(k);
    scene.points.x[p] = 1 + 0.4 * k, scene.points.y[p] = 3 - 1.6 / 3 * k;
  }
  return scene;
}

/// The points of the string weigh .001 for each of its three pieces.
const Pendulum pendulum{2, 10, std::atan(0.75), 0.0015};

Comparison pendulum_comparison(double slower) {
  const auto x = [&](double t) { return 1 + 2 * std::sin(pendulum.angle(t / slower)); };
  const auto y = [&](double t) { return 3 - 2 * std::cos(pendulum.angle(t / slower)); };
  return compare(pendulum_scene(), history_of(slower * pendulum.period() / 1001, 1700, x, y), {});
}

TEST(ComparePendulum, TheExactMotionHasNoError) {
  const Comparison comparison = pendulum_comparison(1);
  ASSERT_EQ(comparison.merits.size(), 1u);
  const Merit& period = merit_of(comparison, "period");
  // 2 pi sqrt(L/g) (1 + theta^2/16 + 11 theta^4/3072 + 173 theta^6/737280 + ...), theta = atan(3/4)
  const double square = std::atan(0.75) * std::atan(0.75);
  const double series = 1 + square / 16 + 11 * square * square / 3072 + 173 * square * square * square / 737280;
  EXPECT_NEAR(period.exact, 2 * pi * std::sqrt(0.2 * 1.0005 / 1.00075) * series, 1e-5);
  EXPECT_NEAR(period.error, 0, 1e-7);
  EXPECT_EQ(comparison.exact.names, (std::vector<std::string>{"time", "point_x_2"}));
  EXPECT_NEAR(comparison.exact.columns[1][0], 2.2, 1e-14);
}

/// Of E A = 2000, three quarters as thick as it is apart (1/4 a point, 2/3 from one to the next), a mass that
/// weighs 20.
TEST(ComparePendulum, TheStringIsAsLongAsTheMassStretchesIt) {
  Scene scene = pendulum_scene();
  const History still = history_of(
      1, 4, [](double) { return 1.0; }, nowhere);
  const double rigid = merit_of(compare(scene, still, {}), "period").exact;
  scene.bodies[0].material = Membrane{2000 / 0.375, 0, false};
  EXPECT_NEAR(merit_of(compare(scene, still, {}), "period").exact, rigid * std::sqrt(1.01), 1e-10);
}

TEST(ComparePendulum, ASlowerSwingHasTheErrorOfItsPeriod) {
  EXPECT_NEAR(merit_of(pendulum_comparison(0.97), "period").error, -0.03, 1e-7);
}

/// Adds rows x columns points of a fluid, 1/4 apart, below the string: L = rows/4, one unit deep A = columns/4.
Scene piston_scene(int rows, int columns) {
  Scene scene = hanging_string(ReferenceKind::piston);
  scene.bodies.push_back({"fluid", LinearFluid{4}, 1, 0, 4, static_cast<std::size_t>(rows * columns)});
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) add_point(scene.points, 0.25 * i + 0.125, 0.25 * j + 0.125, 0.0625, 0.0625);
  }
  return scene;
}

/// L = 2, c = 2 and m = K / (pi/2)^2: omega L / c = pi/2 makes the cotangent of (6.2) vanish, and the period is 4.
Comparison piston_comparison(int columns, double period) {
  Scene scene = piston_scene(8, columns);
  scene.points.mass[3] = 8.0 / 3 * 4 / (pi * pi);
  const auto y = [period](double t) { return 1.5 + 1e-3 * std::sin(2 * pi * t / period); };
  return compare(scene, history_of(period / 400, 900, nowhere, y), {});
}

TEST(ComparePiston, TheExactMotionHasNoError) {
  const Comparison comparison = piston_comparison(1, 4);
  EXPECT_NEAR(merit_of(comparison, "period").exact, 4, 1e-13);
  EXPECT_NEAR(merit_of(comparison, "period").error, 0, 1e-12);
}

TEST(ComparePiston, ASlowerPistonHasTheErrorOfItsPeriod) {
  EXPECT_NEAR(merit_of(piston_comparison(1, 4.2), "period").error, 0.05, 1e-12);
}

TEST(ComparePiston, TheFluidMayBeSeveralPointsWide) {
  EXPECT_NEAR(merit_of(piston_comparison(2, 4), "period").exact, 4, 1e-13);
}

TEST(CompareNone, IsEmpty) {
  const Comparison comparison = compare(hanging_string(ReferenceKind::none), {}, {});
  EXPECT_TRUE(comparison.merits.empty());
  EXPECT_TRUE(comparison.exact.names.empty());
  EXPECT_TRUE(summary_of(comparison).empty());
}

TEST(SummaryOf, NamesTheValueTheExactOneAndTheError) {
  const Comparison comparison{{{"period", 1.5, 1.25, 0.2, false}, {"density", 0, 0, 0.0625, true}}, {}};
  EXPECT_EQ(
      summary_of(comparison),
      (Summary{{"period", "1.5"}, {"exact_period", "1.25"}, {"error_period", "0.2"}, {"error_density", "0.0625"}}));
}

}  // namespace
}  // namespace tether::test
