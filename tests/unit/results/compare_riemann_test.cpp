// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <stdexcept>
#include <utility>

#include "reference/riemann.hpp"
#include "unit/results/compare_support.hpp"

namespace tether::test {
namespace {

constexpr double sod_time = 0.2;
constexpr int columns = 100;

/// Sod's states: p = .4 rho i.
const RiemannSolution sod = solve_riemann({{1, 0, 1}, {0.125, 0, 0.1}, 1.4, 0.5});

/// The left half of the tube at the density 1, the right half at 1/8, one point in each column of cells.
Scene sod_scene() {
  Scene scene;
  scene.reference = ReferenceKind::riemann;
  scene.grid = BackgroundGrid(columns + 1, 2, 0, 1, 0, 0.01);
  for (int k = 0; k < columns; ++k) add_point(scene.points, (k + 0.5) / columns, 0.005, 1e-4, 1e-4);
  IdealGas air;
  air.gm1 = 0.4;
  scene.bodies = {{"left", air, 1, 2.5, 0, columns / 2}, {"right", air, 0.125, 2, columns / 2, columns / 2}};
  return scene;
}

/// What a point of column k knows; `density_off` is added to its density.
Snapshot sod_snapshot(const std::function<double(int)>& density_off, int step = 1) {
  Snapshot snapshot{sod_time, {}};
  for (const char* name : {"x", "density", "vx", "pressure", "specific_energy"}) {
    snapshot.fields.push_back({{name, Dimension::number, ""}, {}});
  }
  for (int k = 0; k < columns; k += step) {
    const double x = (k + 0.5) / columns;
    const GasSample gas = sample(sod, x, sod_time);
    const double row[] = {x, gas.density + density_off(k), gas.velocity, gas.pressure, gas.specific_energy};
    for (std::size_t c = 0; c < 5; ++c) snapshot.fields[c].values.push_back(row[c]);
  }
  return snapshot;
}

double exactly(int) { return 0; }

TEST(CompareRiemann, TheExactProfilesHaveNoError) {
  const Comparison comparison = compare(sod_scene(), {}, sod_snapshot(exactly));
  ASSERT_EQ(comparison.merits.size(), 4u);
  for (const char* name : {"density", "velocity", "pressure", "specific_energy"}) {
    EXPECT_NEAR(merit_of(comparison, name).error, 0, 1e-13) << name;
    EXPECT_TRUE(merit_of(comparison, name).profile);
  }
}

/// The rarefaction's head runs at 1.18 to the left, it is at x = 0 from .42 on; the shock is at x = 1 from .285 on.
TEST(CompareRiemann, EndsWhereWavesComeFromTheEnds) {
  Snapshot late = sod_snapshot(exactly);
  late.time = 0.32;
  const Comparison comparison = compare(sod_scene(), {}, late);
  ASSERT_TRUE(comparison.window);
  EXPECT_EQ(comparison.window->front(), 0);
  EXPECT_GT(comparison.window->back(), 0.96);  // the shock sent back is slower than that which came, 1.75
  EXPECT_LT(comparison.window->back(), 1);
  const Summary summary = summary_of(comparison);
  EXPECT_EQ(summary[4].first, "compared_from");
  EXPECT_EQ(summary[5].first, "compared_to");
}

/// Behind the shock that a wall sends back the profile is another, and no column there counts.
TEST(CompareRiemann, WhatTheEndsSendBackDoesNotCount) {
  const double t = 0.32;
  Snapshot late = sod_snapshot(exactly);
  late.time = t;
  const double front = compare(sod_scene(), {}, late).window->back();
  for (int k = 0; k < columns; ++k) {
    const auto c = static_cast<std::size_t>(k);
    const double x = (k + 0.5) / columns;
    const GasSample gas = sample(sod, x, t);
    const double here = x > front ? 3 * gas.density : gas.density;
    late.fields[1].values[c] = here;
  }
  EXPECT_NEAR(merit_of(compare(sod_scene(), {}, late), "density").error, 0, 1e-12);
}

TEST(CompareRiemann, IsRefusedOnceAShockFromAWallHasMetTheContact) {
  Snapshot late = sod_snapshot(exactly);
  late.time = 0.6;
  EXPECT_THROW(compare(sod_scene(), {}, late), std::domain_error);
}

TEST(CompareRiemann, AWindowIsThePartThatIsCompared) {
  Scene scene = sod_scene();
  scene.reference_window = {{0.2, 0.6}};
  const auto error = [&](const std::function<double(int)>& off) {
    return merit_of(compare(scene, {}, sod_snapshot(off)), "density").error;
  };
  EXPECT_NEAR(error([](int k) { return k < 20 || k >= 60 ? 5 : 0; }), 0, 1e-13);
  EXPECT_NEAR(error([](int k) { return k == 20 ? 4 : 0; }), 0.1, 1e-13);
  scene.reference_window = {{0.2, 1}};
  Snapshot late = sod_snapshot(exactly);
  late.time = 0.32;
  EXPECT_THROW(compare(scene, {}, late), std::domain_error);
}

TEST(CompareRiemann, ErrorIsTheMeanDistance) {
  const auto error = [](const std::function<double(int)>& off) {
    const Comparison comparison = compare(sod_scene(), {}, sod_snapshot(off));
    EXPECT_NEAR(merit_of(comparison, "pressure").error, 0, 1e-13);
    return merit_of(comparison, "density").error;
  };
  EXPECT_NEAR(error([](int) { return 0.1; }), 0.1, 1e-13);
  EXPECT_NEAR(error([](int k) { return k % 2 == 0 ? 0.1 : -0.1; }), 0.1,
              1e-13);  // columns do not make up for each other
  EXPECT_NEAR(error([](int k) { return k == 7 ? -0.5 : 0; }), 0.005, 1e-13);
}

TEST(CompareRiemann, PointsOfOneColumnAreAveraged) {
  Snapshot twice = sod_snapshot([](int) { return 0.1; });
  const Snapshot other = sod_snapshot([](int) { return -0.1; });
  for (std::size_t c = 0; c < 5; ++c) {
    auto& values = twice.fields[c].values;
    values.insert(values.end(), other.fields[c].values.begin(), other.fields[c].values.end());
  }
  EXPECT_NEAR(merit_of(compare(sod_scene(), {}, twice), "density").error, 0, 1e-13);
}

TEST(CompareRiemann, ColumnsWithoutPointsDoNotCount) {
  const Comparison comparison = compare(sod_scene(), {}, sod_snapshot([](int k) { return k == 4 ? 0.5 : 0; }, 4));
  EXPECT_NEAR(merit_of(comparison, "density").error, 0.5 / 25, 1e-13);
}

TEST(CompareRiemann, TheOrderOfTheBodiesDoesNotMatter) {
  Scene scene = sod_scene();
  std::swap(scene.bodies[0], scene.bodies[1]);
  const Comparison comparison = compare(scene, {}, sod_snapshot(exactly));
  for (const Merit& merit : comparison.merits) EXPECT_NEAR(merit.error, 0, 1e-13) << merit.name;
}

/// Both states move at .5, and with them the whole solution: the profiles of rest are shifted by .075 at t = .15. The
/// left wall sends a rarefaction after the gas, at u + a = 1.68, ahead of which all is as it was.
TEST(CompareRiemann, VelocityOfTheStatesIsPartOfTheProblem) {
  Scene scene = sod_scene();
  for (double& vx : scene.points.vx) vx = 0.5;
  Snapshot early = sod_snapshot(exactly);
  early.time = 0.15;
  const Comparison moving = compare(scene, {}, early);
  const auto& columns_of = moving.exact.columns;
  for (std::size_t k = 100; k <= 1000; k += 50) {
    const GasSample rest = sample(sod, columns_of[0][k] - 0.075, early.time);
    EXPECT_NEAR(columns_of[1][k], rest.density, 1e-12);
    EXPECT_NEAR(columns_of[2][k], rest.velocity + 0.5, 1e-12);
  }
  EXPECT_GT(merit_of(moving, "velocity").error, 0.3);
  EXPECT_NEAR(moving.window->front(), 0.15 * (0.5 + std::sqrt(1.4)), 1e-9);
  EXPECT_LT(moving.window->back(), 0.9);  // a shock comes from the right wall, into which the gas runs
}

/// Star values of Toro's test 1: p = .30313, u = .92745, densities .42632 and .26557.
TEST(CompareRiemann, TabulatesTheExactProfilesAcrossTheGrid) {
  const Table table = compare(sod_scene(), {}, sod_snapshot(exactly)).exact;
  EXPECT_EQ(table.names, (std::vector<std::string>{"x", "density", "velocity", "pressure", "specific_energy"}));
  ASSERT_EQ(table.columns.size(), 5u);
  ASSERT_EQ(table.columns[0].size(), 1001u);
  EXPECT_EQ(table.columns[0][0], 0);
  EXPECT_EQ(table.columns[0][1000], 1);
  EXPECT_EQ(table.columns[1][0], 1);
  EXPECT_EQ(table.columns[1][1000], 0.125);
  for (const std::size_t k : {std::size_t{600}, std::size_t{750}}) {  // on both sides of the contact at .685
    EXPECT_NEAR(table.columns[2][k], 0.92745, 5e-6);
    EXPECT_NEAR(table.columns[3][k], 0.30313, 5e-6);
  }
  EXPECT_NEAR(table.columns[1][600], 0.42632, 5e-6);
  EXPECT_NEAR(table.columns[1][750], 0.26557, 5e-6);
  EXPECT_NEAR(table.columns[4][600], 0.30313 / (0.4 * 0.42632), 5e-5);
}

TEST(CompareRiemann, NeedsItsFields) {
  Snapshot snapshot = sod_snapshot(exactly);
  snapshot.fields.pop_back();
  EXPECT_THROW(compare(sod_scene(), {}, snapshot), std::out_of_range);
}

}  // namespace
}  // namespace tether::test
