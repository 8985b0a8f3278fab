// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "reference/thin_ring.hpp"
#include "unit/results/compare_support.hpp"

namespace tether::test {
namespace {

using std::numbers::pi;

constexpr int pieces = 30;
constexpr double start_radius = 1.2, thickness = 0.05, half_piece = pi / 4 / pieces;

/// A quarter of a ring about the corner (-1, 2) of the grid, between two bodies of gas: 3 points of the mass .1 and the
/// energy 50, 2 of the mass .2 and the energy 75. From bottom to left, or the other way.
Scene ring_scene(bool from_bottom, Membrane::Kind kind = Membrane::Kind::plane_stress) {
  Scene scene;
  scene.reference = ReferenceKind::thin_ring;
  scene.grid = BackgroundGrid(21, 21, -1, 1, 2, 4);
  for (int k = 0; k < 3; ++k) add_point(scene.points, -0.5, 2.5, 0.1, 0.1);
  const double chord = 2 * start_radius * std::sin(half_piece);
  for (int k = 0; k < pieces; ++k) {
    const double angle = (2 * k + 1) * half_piece, a = from_bottom ? angle : pi / 2 - angle;
    add_point(scene.points, -1 + start_radius * std::cos(a), 2 + start_radius * std::sin(a), thickness * chord, 0.01);
  }
  for (int k = 0; k < 2; ++k) add_point(scene.points, -0.4, 2.4, 0.2, 0.2);
  IdealGas gas;
  gas.gm1 = 0.4;
  const Membrane membrane{1e5, 0.3, true, kind};
  scene.bodies = {
      {"gas", gas, 1, 50, 0, 3}, {"membrane", membrane, 0.5, 0, 3, pieces}, {"more gas", gas, 1, 75, 33, 2}};
  return scene;
}

/// Length by its chords, and half of one at either wall, where the image follows.
RingAtRest exact(double poisson) {
  const double length = pieces * 2 * start_radius * std::sin(half_piece);
  return ring_at_rest({length, thickness, 1e5, poisson, 0.4, 0.3 * 50 + 0.4 * 75});
}

/// The ring at rest on an ellipse, pressures that scatter about a mean, and a stress along the tangent.
Snapshot at_rest(bool from_bottom, double radius_x, double radius_y, double pressure, double stress) {
  Snapshot snapshot{8.5, {}};
  for (const char* name : {"x", "y", "pressure", "sxx", "syy"}) {
    snapshot.fields.push_back({{name, Dimension::number, ""}, {}});
  }
  const auto add = [&](double x, double y, double p, double sxx, double syy) {
    const double row[] = {x, y, p, sxx, syy};
    for (std::size_t c = 0; c < 5; ++c) snapshot.fields[c].values.push_back(row[c]);
  };
  for (int k = 0; k < 3; ++k) add(-0.7, 2.2, pressure - (k - 1) * 3, -pressure, -pressure);
  for (int k = 0; k < pieces; ++k) {
    const double a = (from_bottom ? k : pieces - 1 - k) * pi / 2 / (pieces - 1), c = std::cos(a), s = std::sin(a);
    add(-1 + radius_x * c, 2 + radius_y * s, -77, stress * s * s, stress * c * c);
  }
  for (int k = 0; k < 2; ++k) add(-0.6, 2.3, pressure - (2 * k - 1) * 5, -pressure, -pressure);
  return snapshot;
}

TEST(CompareThinRing, TheRingAtRestHasNoError) {
  const RingAtRest rest = exact(0.3);
  for (const bool from_bottom : {true, false}) {
    const Comparison comparison = compare(
        ring_scene(from_bottom), {}, at_rest(from_bottom, rest.radius, rest.radius, rest.pressure, rest.hoop_stress));
    ASSERT_EQ(comparison.merits.size(), 4u);
    for (const Merit& merit : comparison.merits) {
      EXPECT_NEAR(merit.error, 0, 1e-12) << merit.name;
      EXPECT_FALSE(merit.profile);
    }
    EXPECT_TRUE(comparison.exact.names.empty());
  }
}

TEST(CompareThinRing, EachQuantityHasItsOwnError) {
  const RingAtRest rest = exact(0.3);
  for (const bool from_bottom : {true, false}) {
    const Comparison comparison = compare(
        ring_scene(from_bottom), {},
        at_rest(from_bottom, 1.01 * rest.radius, 0.98 * rest.radius, 1.03 * rest.pressure, 0.9 * rest.hoop_stress));
    EXPECT_NEAR(merit_of(comparison, "radius_x").error, 0.01, 1e-12);
    EXPECT_NEAR(merit_of(comparison, "radius_y").error, -0.02, 1e-12);
    EXPECT_NEAR(merit_of(comparison, "pressure").error, 0.03, 1e-12);
    EXPECT_NEAR(merit_of(comparison, "stress").error, -0.1, 1e-12);
    EXPECT_NEAR(merit_of(comparison, "stress").here, 0.9 * rest.hoop_stress, 1e-9);
  }
}

/// E / (1 - nu^2) resists in a membrane, E in a string.
TEST(CompareThinRing, StiffnessIsTheLaws) {
  const RingAtRest rest = exact(0);
  const Snapshot last = at_rest(true, rest.radius, rest.radius, rest.pressure, rest.hoop_stress);
  const Comparison string = compare(ring_scene(true, Membrane::Kind::uniaxial), {}, last);
  EXPECT_NEAR(merit_of(string, "radius_x").error, 0, 1e-12);
  EXPECT_GT(merit_of(compare(ring_scene(true), {}, last), "radius_x").error, 1e-4);
}

}  // namespace
}  // namespace tether::test
