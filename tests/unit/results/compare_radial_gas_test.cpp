// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "reference/radial_gas.hpp"
#include "unit/results/compare_support.hpp"

namespace tether::test {
namespace {

using std::numbers::pi;

constexpr GasCylinder cylinder{0.376, 2, 250, 0.4};
constexpr int count = 2000;
constexpr double end_time = 0.005;
/// What 2,000 points leave of the thin gas at the edge.
constexpr double points_at_the_edge = 1e-5;

/// A quarter of the cylinder as points of equal mass along the diagonal, about the corner (0.5, 0.25) of the grid.
Scene quarter() {
  Scene scene;
  scene.reference = ReferenceKind::radial_gas;
  scene.grid = BackgroundGrid(21, 21, 0.5, 1.5, 0.25, 1.25);
  const double area = pi * cylinder.radius * cylinder.radius / 4 / count;
  for (int k = 0; k < count; ++k) add_point(scene.points, 0, 0, area, cylinder.density * area);
  IdealGas gas;
  gas.gm1 = cylinder.gm1;
  scene.bodies = {{"gas", gas, cylinder.density, cylinder.specific_energy, 0, count}};
  return scene;
}

/// Each point at the radius of the exact solution that holds the mass of those nearer and half its own, and in this
/// order or the other.
Snapshot exact_places(double stretch, bool outermost_first = false) {
  const GasShells exact = expanded(shells_of(cylinder), end_time);
  Snapshot snapshot{end_time, {{{"x", Dimension::length, ""}, {}}, {{"y", Dimension::length, ""}, {}}}};
  for (int k = 0; k < count; ++k) {
    const int n = outermost_first ? count - 1 - k : k;
    const double r = stretch * exact.radius_of_share((n + 0.5) / count);
    snapshot.fields[0].values.push_back(0.5 + 0.6 * r);
    snapshot.fields[1].values.push_back(0.25 + 0.8 * r);
  }
  return snapshot;
}

TEST(CompareRadialGas, TheExactPlacesHaveNoError) {
  for (const bool outermost_first : {false, true}) {
    const Comparison comparison = compare(quarter(), {}, exact_places(1, outermost_first));
    ASSERT_EQ(comparison.merits.size(), 2u);
    EXPECT_NEAR(merit_of(comparison, "rms_radius").exact, 0.27547, 5e-6);
    EXPECT_NEAR(merit_of(comparison, "radius_95").exact, 0.41068, 5e-6);
    for (const Merit& merit : comparison.merits) {
      EXPECT_NEAR(merit.error, 0, points_at_the_edge) << merit.name;
      EXPECT_FALSE(merit.profile);
    }
  }
}

TEST(CompareRadialGas, WiderGasHasTheErrorOfItsWidth) {
  const Comparison comparison = compare(quarter(), {}, exact_places(1.02));
  for (const Merit& merit : comparison.merits) EXPECT_NEAR(merit.error, 0.02, points_at_the_edge) << merit.name;
}

/// The 95 % are of the mass, not of the points: a last tenth of points twice as heavy.
TEST(CompareRadialGas, HeavierPointsCountForMore) {
  Scene scene = quarter();
  for (int k = 1800; k < count; ++k) scene.points.mass[static_cast<std::size_t>(k)] *= 2;
  const Comparison comparison = compare(scene, {}, exact_places(1));
  const double expected = expanded(shells_of(cylinder), end_time).radius_of_share(1945.0 / 2000);
  EXPECT_NEAR(merit_of(comparison, "radius_95").here, expected, points_at_the_edge);
}

TEST(CompareRadialGas, TabulatesTheExactProfiles) {
  const Table table = compare(quarter(), {}, exact_places(1)).exact;
  EXPECT_EQ(table.names,
            (std::vector<std::string>{"radius", "density", "velocity", "pressure", "specific_energy", "mass_inside"}));
  const RadialProfile profile = profile_of(expanded(shells_of(cylinder), end_time));
  ASSERT_EQ(table.columns.size(), 6u);
  ASSERT_EQ(table.columns[0].size(), 1600u);
  // The deck's radius comes back from the points' volumes to rounding, not to the bit.
  const std::vector<double>* expected[] = {&profile.radius,   &profile.density,         &profile.velocity,
                                           &profile.pressure, &profile.specific_energy, &profile.mass_inside};
  for (std::size_t c = 0; c < 6; ++c) {
    for (const std::size_t k : {0u, 700u, 1599u}) {
      const double value = (*expected[c])[k];
      EXPECT_NEAR(table.columns[c][k], value, 1e-9 * (1 + std::abs(value))) << c;
    }
  }
}

TEST(CompareRadialGas, IsRefusedOnceTheGasIsAtAnEdge) {
  Scene scene = quarter();
  EXPECT_NO_THROW(compare(scene, {}, exact_places(1)));
  scene.grid = BackgroundGrid(21, 21, 0.5, 1.5, 0.25, 0.73);  // .48, of the radius .4722 that holds 99 %
  EXPECT_NO_THROW(compare(scene, {}, exact_places(1)));
  scene.grid = BackgroundGrid(21, 21, 0.5, 0.96, 0.25, 1.25);
  EXPECT_THROW(compare(scene, {}, exact_places(1)), std::domain_error);
}

}  // namespace
}  // namespace tether::test
