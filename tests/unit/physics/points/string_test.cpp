// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "physics/points/elements.hpp"
#include "physics/points/state.hpp"
#include "unit/physics/scenes.hpp"

namespace tether::mpm {
namespace {

/// A string of four points along the 3-4-5 direction, with an initial stress.
Scene slanted_string(double stress, bool wrinkle) {
  Scene scene = scenes::open_scene(6, 6);
  PointSet& P = scene.points;
  for (int k = 0; k < 4; ++k) {
    P.x.push_back(1 + 0.6 * k), P.y.push_back(1 + 0.8 * k);
    P.vx.push_back(0), P.vy.push_back(0);
    P.sxx.push_back(stress * 0.36), P.syy.push_back(stress * 0.64), P.sxy.push_back(stress * 0.48);
    P.volume.push_back(0.1), P.mass.push_back(0.1);
  }
  scene.bodies.push_back({"string", Membrane{100, 0, wrinkle}, 1, 0, 0, 4});
  return scene;
}

TEST(String, TangentsFollowTheNeighbours) {
  State state = start(slanted_string(0, true));
  for (std::size_t p = 0; p < 4; ++p) {
    EXPECT_NEAR(state.points.tx[p], 0.6, 1e-15);
    EXPECT_NEAR(state.points.ty[p], 0.8, 1e-15);
  }
  state.points.x[3] = state.points.x[1], state.points.y[3] = state.points.y[1] + 2;  // its far end swings up
  const Vec<2> inner = tangent_at(state.points, {0, 4}, 2), end = tangent_at(state.points, {0, 4}, 3);
  EXPECT_NEAR(inner[0], 0, 1e-15);
  EXPECT_NEAR(inner[1], 1, 1e-15);
  EXPECT_NEAR(end[0], -0.6 / std::hypot(0.6, 1.2), 1e-15);
}

TEST(String, AnInitialStressIsAnInitialStrain) {
  const State taut = start(slanted_string(50, true));
  EXPECT_NEAR(taut.points.strain[1], 0.5, 1e-14);
  EXPECT_NEAR(taut.points.syy[1], 32, 1e-12);
  const State slack = start(slanted_string(-50, true));
  EXPECT_NEAR(slack.points.strain[1], -0.5, 1e-14);
  EXPECT_EQ(slack.points.syy[1], 0);
  const State strut = start(slanted_string(-50, false));
  EXPECT_NEAR(strut.points.syy[1], -32, 1e-12);
}

TEST(String, StretchesAlongItsTangentOnly) {
  State state = start(slanted_string(0, true));
  Points& P = state.points;
  for (std::size_t p = 0; p < 4; ++p) P.dxx[p] = 0.64, P.dyy[p] = 0.36, P.dxy[p] = -0.48;  // across the string
  stretch_along_tangents(P, {0, 4}, 0.1);
  for (const double strain : P.strain) EXPECT_NEAR(strain, 0, 1e-15);
  for (std::size_t p = 0; p < 4; ++p) P.dxx[p] = 0.36, P.dyy[p] = 0.64, P.dxy[p] = 0.48;  // along it
  stretch_along_tangents(P, {0, 4}, 0.1);
  for (const double strain : P.strain) EXPECT_NEAR(strain, 0.1, 1e-15);
}

// (5.3): what lies along the new tangent remains, cos^2 of the angle between them.
TEST(String, TurningKeepsTheComponentAlongTheNewTangent) {
  State state = start(slanted_string(50, true));
  Points& P = state.points;
  for (std::size_t p = 0; p < 4; ++p) P.x[p] = 1, P.y[p] = 1 + static_cast<double>(p);
  turn_tangents(P, {0, 4});
  for (std::size_t p = 0; p < 4; ++p) {
    EXPECT_NEAR(P.strain[p], 0.5 * 0.64, 1e-14);
    EXPECT_NEAR(P.ty[p], 1, 1e-15);
  }
}

TEST(String, NeighboursInOnePlaceKeepTheTangent) {
  State state = start(slanted_string(50, true));
  Points& P = state.points;
  for (std::size_t p = 0; p < 4; ++p) P.x[p] = P.y[p] = 2;
  turn_tangents(P, {0, 4});
  for (std::size_t p = 0; p < 4; ++p) {
    EXPECT_NEAR(P.tx[p], 0.6, 1e-15);
    EXPECT_NEAR(P.strain[p], 0.5, 1e-14);
  }
}

}  // namespace
}  // namespace tether::mpm
