// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/kernels.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace tether {
namespace {

constexpr double dx = 0.5, dy = 0.25;
/// Nodes of a cell counter-clockwise from the lower left, in logical coordinates (A.3.1).
constexpr std::array<double, 4> node_r{0, 1, 1, 0}, node_s{0, 0, 1, 1};

std::vector<CellPlace> places() {
  std::vector<CellPlace> all;
  for (const double r : {0.0, 0.1, 0.37, 0.5, 1.0}) {
    for (const double s : {0.0, 0.2, 0.5, 0.93, 1.0}) all.push_back({0, 0, r, s});
  }
  return all;
}

/// Derivative of N_k in x or y by a central difference, which is exact for a bilinear function but for rounding.
double slope(int k, const CellPlace& at, double step_x, double step_y) {
  const auto N = [&](double sign) {
    const CellPlace moved{0, 0, at.r + sign * step_x / dx, at.s + sign * step_y / dy};
    return LinearShape(moved).N[static_cast<std::size_t>(k)];
  };
  return (N(1) - N(-1)) / (2 * (step_x + step_y));
}

TEST(LinearShapeTest, IsOneAtItsNodeAndZeroAtTheOthers) {
  for (std::size_t n = 0; n < 4; ++n) {
    const LinearShape shape({0, 0, node_r[n], node_s[n]});
    for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(shape.N[k], k == n ? 1 : 0);
  }
}

TEST(LinearShapeTest, SumIsOneAndLinearFieldsAreReproduced) {
  for (const CellPlace& at : places()) {
    const LinearShape shape(at);
    double one = 0, field = 0;
    for (std::size_t k = 0; k < 4; ++k) one += shape.N[k], field += shape.N[k] * (2 - 3 * node_r[k] + 5 * node_s[k]);
    EXPECT_NEAR(one, 1, 1e-15);
    EXPECT_NEAR(field, 2 - 3 * at.r + 5 * at.s, 1e-14);
  }
}

TEST(LinearShapeTest, ValuesAtAPlace) {
  const LinearShape shape({7, 3, 0.25, 0.5});  // the cell's number does not matter
  EXPECT_EQ(shape.N, (std::array<double, 4>{0.375, 0.125, 0.125, 0.375}));
}

TEST(LinearGradientTest, IsTheSlopeOfTheShapeFunctions) {
  const double step = 1e-3;
  for (const CellPlace& at : places()) {
    const LinearGradient G(at, 1 / dx, 1 / dy);
    for (int k = 0; k < 4; ++k) {
      std::array<Pair, 4> unit{};
      unit[static_cast<std::size_t>(k)] = pair(1, -2);
      const Pair x = G.by_x(unit), y = G.by_y(unit);
      EXPECT_NEAR(x[0], slope(k, at, step, 0), 1e-12);
      EXPECT_NEAR(x[1], -2 * slope(k, at, step, 0), 1e-12);
      EXPECT_NEAR(y[0], slope(k, at, 0, step), 1e-12);
      EXPECT_NEAR(y[1], -2 * slope(k, at, 0, step), 1e-12);
    }
  }
}

TEST(LinearGradientTest, OfALinearVelocityIsItsGradient) {
  std::array<Pair, 4> v;  // v = (3 + 2 x - 7 y, 1 - x + 4 y)
  for (std::size_t k = 0; k < 4; ++k) {
    const double x = node_r[k] * dx, y = node_s[k] * dy;
    v[k] = pair(3 + 2 * x - 7 * y, 1 - x + 4 * y);
  }
  for (const CellPlace& at : places()) {
    const LinearGradient G(at, 1 / dx, 1 / dy);
    const Pair x = G.by_x(v), y = G.by_y(v);
    EXPECT_NEAR(x[0], 2, 1e-14);
    EXPECT_NEAR(x[1], -1, 1e-14);
    EXPECT_NEAR(y[0], -7, 1e-14);
    EXPECT_NEAR(y[1], 4, 1e-14);
  }
}

/// (3.16): f_i = -V (sigma_xx G_ix + sigma_xy G_iy, sigma_xy G_ix + sigma_yy G_iy).
TEST(LinearGradientTest, MinusDivergenceIsTheForceOfAStress) {
  const Pair a = pair(11, 3), b = pair(3, -5);  // the columns (xx, xy) and (xy, yy) of V sigma
  const double step = 1e-3;
  for (const CellPlace& at : places()) {
    const auto f = LinearGradient(at, 1 / dx, 1 / dy).minus_divergence(a, b);
    for (std::size_t k = 0; k < 4; ++k) {
      const double gx = slope(static_cast<int>(k), at, step, 0), gy = slope(static_cast<int>(k), at, 0, step);
      EXPECT_NEAR(f[k][0], -(11 * gx + 3 * gy), 1e-10);
      EXPECT_NEAR(f[k][1], -(3 * gx - 5 * gy), 1e-10);
    }
  }
}

TEST(LinearGradientTest, NodalForcesOfAPointBalanceInSumAndInMoment) {
  const Pair a = pair(11, 3), b = pair(3, -5);
  for (const CellPlace& at : places()) {
    const auto f = LinearGradient(at, 1 / dx, 1 / dy).minus_divergence(a, b);
    double fx = 0, fy = 0, moment = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      fx += f[k][0], fy += f[k][1];
      moment += node_r[k] * dx * f[k][1] - node_s[k] * dy * f[k][0];
    }
    EXPECT_NEAR(fx, 0, 1e-13);
    EXPECT_NEAR(fy, 0, 1e-13);
    EXPECT_NEAR(moment, 0, 1e-13);  // as the stress is symmetric
  }
}

/// The nodes' power is minus the point's: sum f_i . v_i = -V sigma : grad v, whatever the velocities.
TEST(LinearGradientTest, NodalPowerIsMinusTheStressPower) {
  const Pair a = pair(11, 3), b = pair(3, -5);
  const std::array<Pair, 4> v{pair(1, 2), pair(-3, 0.5), pair(4, -1), pair(0.25, 7)};
  for (const CellPlace& at : places()) {
    const LinearGradient G(at, 1 / dx, 1 / dy);
    const auto f = G.minus_divergence(a, b);
    double nodes = 0;
    for (std::size_t k = 0; k < 4; ++k) nodes += f[k][0] * v[k][0] + f[k][1] * v[k][1];
    const Pair x = G.by_x(v), y = G.by_y(v);
    EXPECT_NEAR(nodes, -(11 * x[0] + 3 * (y[0] + x[1]) - 5 * y[1]), 1e-11);
  }
}

TEST(QuadraticWeights, SumIsOneAndLinearFieldsAreReproduced) {
  for (const double r : {-0.5, -0.31, 0.0, 0.125, 0.5}) {
    const auto w = quadratic_weights(r);
    EXPECT_NEAR(w[0] + w[1] + w[2], 1, 1e-15);
    EXPECT_NEAR(w[2] - w[0], r, 1e-15);  // the cells' middles stand at -1, 0, 1
  }
}

TEST(QuadraticWeights, ValuesOfTable12) {
  EXPECT_EQ(quadratic_weights(0), (std::array<double, 3>{0.125, 0.75, 0.125}));
  EXPECT_EQ(quadratic_weights(0.5), (std::array<double, 3>{0, 0.5, 0.5}));
  EXPECT_EQ(quadratic_weights(-0.5), (std::array<double, 3>{0.5, 0.5, 0}));
  EXPECT_EQ(quadratic_weights(0.25), (std::array<double, 3>{0.03125, 0.6875, 0.28125}));
}

/// The nine functions are the products of two: three of Table 12 at r = .25, s = -.5.
TEST(QuadraticWeights, ProductsAreTheNineFunctionsOfTable12) {
  const double r = 0.25, s = -0.5;
  const auto x = quadratic_weights(r), y = quadratic_weights(s);
  EXPECT_EQ(x[1] * y[1], (0.75 - r * r) * (0.75 - s * s));
  EXPECT_EQ(x[2] * y[1], 0.5 * (0.5 + r) * (0.5 + r) * (0.75 - s * s));
  EXPECT_EQ(x[1] * y[0], 0.5 * (0.75 - r * r) * (0.5 - s) * (0.5 - s));
  EXPECT_EQ(x[0] * y[0], 0.25 * ((0.5 - r) * (0.5 - s)) * ((0.5 - r) * (0.5 - s)));
}

TEST(QuadraticWeights, MeetWithoutAJumpWhereAPointChangesCells) {
  const auto left = quadratic_weights(0.5), right = quadratic_weights(-0.5);
  EXPECT_EQ(left[0], 0);
  EXPECT_EQ(left[1], right[0]);
  EXPECT_EQ(left[2], right[1]);
  EXPECT_EQ(right[2], 0);
}

/// A central difference is exact for a quadratic but for rounding.
TEST(QuadraticSlopes, AreTheSlopesOfTheWeights) {
  const double step = 1e-3;
  for (const double r : {-0.5, -0.31, 0.0, 0.125, 0.5}) {
    const auto behind = quadratic_weights(r + step), before = quadratic_weights(r - step), slope = quadratic_slopes(r);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR((behind[k] - before[k]) / (2 * step), slope[k], 1e-12);
  }
}

/// Products with the other axis' weights are Table 13: S_2x and S_9y at r = .25, s = -.5, times a cell's side.
TEST(QuadraticSlopes, ValuesOfTable13) {
  const double r = 0.25, s = -0.5;
  EXPECT_EQ(quadratic_slopes(r)[2] * quadratic_weights(s)[1], (0.5 + r) * (0.75 - s * s));
  EXPECT_EQ(quadratic_weights(r)[2] * quadratic_slopes(s)[0], -0.5 * (0.5 + r) * (0.5 + r) * (0.5 - s));
}

}  // namespace
}  // namespace tether
