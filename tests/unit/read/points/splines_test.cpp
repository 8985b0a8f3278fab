// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "unit/read/points/curves_support.hpp"

namespace tether::test {
namespace {

using std::numbers::pi;

const std::vector<Vec<2>> bend{{0, 0}, {1, 0.2}, {1.5, 1}, {1.4, 3}, {0.5, 3.5}};

std::vector<Vec<2>> controls(const Stretch& stretch) {
  const auto& control = std::get<Cubic>(stretch).control;
  return {control.begin(), control.end()};
}

/// First (n = 1) or second derivative with respect to the chord length, at the begin or at the end of a stretch.
Vec<2> derivative(const Stretch& stretch, int n, bool at_end) {
  auto c = controls(stretch);
  const double h = distance(c[0], c[3]);
  const auto d = [&](auto get) {
    const double c0 = get(c[0]), c1 = get(c[1]), c2 = get(c[2]), c3 = get(c[3]);
    if (n == 1) return 3 * (at_end ? c3 - c2 : c1 - c0) / h;
    return 6 * (at_end ? c3 - 2 * c2 + c1 : c2 - 2 * c1 + c0) / (h * h);
  };
  return {d([](const Vec<2>& v) { return v[0]; }), d([](const Vec<2>& v) { return v[1]; })};
}

TEST(Splines, RunThroughTheirVerticesSmoothlyAndEndWithoutCurvature) {
  const Curve curve = spline(bend);
  const auto& parts = curve.stretches();
  ASSERT_EQ(parts.size(), 4u);
  for (std::size_t k = 0; k < 4; ++k) {
    expect_near(controls(parts[k])[0], bend[k], 0);
    expect_near(controls(parts[k])[3], bend[k + 1], 0);
    if (k == 0) continue;
    expect_near(derivative(parts[k - 1], 1, true), derivative(parts[k], 1, false), 1e-13);
    expect_near(derivative(parts[k - 1], 2, true), derivative(parts[k], 2, false), 1e-12);
  }
  expect_near(derivative(parts.front(), 2, false), {0, 0}, 1e-12);
  expect_near(derivative(parts.back(), 2, true), {0, 0}, 1e-12);
}

TEST(Splines, ThatCloseAreSmoothAtTheirSeam) {
  auto loop = bend;
  loop.push_back(loop.front());
  const Curve curve = spline(loop);
  const auto& parts = curve.stretches();
  ASSERT_EQ(parts.size(), 5u);
  EXPECT_TRUE(is_closed(curve));
  for (std::size_t k = 0; k < 5; ++k) {
    const Stretch& next = parts[(k + 1) % 5];
    expect_near(derivative(parts[k], 1, true), derivative(next, 1, false), 1e-13);
    expect_near(derivative(parts[k], 2, true), derivative(next, 2, false), 1e-12);
  }
}

TEST(Splines, OfVerticesOnALineAreTheLine) {
  const Curve curve = spline({{0, 0}, {0.3, 0.4}, {3, 4}, {6, 8}});
  EXPECT_NEAR(curve.length(), 10, 1e-13);
  for (const double s : {0.1, 0.77, 5.0, 9.999}) expect_near(curve.at(s), {0.6 * s, 0.8 * s}, 1e-13);
  expect_near(spline({{1, 1}, {2, 1}}).at(0.25), {1.25, 1}, 1e-15);
}

Vec<2> bernstein(const std::vector<Vec<2>>& c, double t) {
  const double q = 1 - t;
  const double w0 = q * q * q, w1 = 3 * q * q * t, w2 = 3 * q * t * t, w3 = t * t * t;
  return {w0 * c[0][0] + w1 * c[1][0] + w2 * c[2][0] + w3 * c[3][0],
          w0 * c[0][1] + w1 * c[1][1] + w2 * c[2][1] + w3 * c[3][1]};
}

double bernstein_speed(const std::vector<Vec<2>>& c, double t) {
  const double q = 1 - t;
  const auto slope = [&](double c0, double c1, double c2, double c3) {
    return 3 * (q * q * (c1 - c0) + 2 * q * t * (c2 - c1) + t * t * (c3 - c2));
  };
  return std::hypot(slope(c[0][0], c[1][0], c[2][0], c[3][0]), slope(c[0][1], c[1][1], c[2][1], c[3][1]));
}

/// The last one turns sharply back at its middle vertex.
class SplineThrough : public testing::TestWithParam<std::vector<Vec<2>>> {};

TEST_P(SplineThrough, IsMeasuredAlongItsLength) {
  const Curve curve = spline(GetParam());
  double begin = 0;
  for (const Stretch& stretch : curve.stretches()) {
    const auto c = controls(stretch);
    const auto speed = [&](double t) { return bernstein_speed(c, t); };
    for (const double t : {0.0, 0.125, 0.5, 0.875, 1.0}) {
      expect_near(curve.at(begin + integral(speed, 0, t)), bernstein(c, t), 1e-10 * curve.length());
    }
    begin += integral(speed, 0, 1);
  }
  EXPECT_NEAR(curve.length(), begin, 1e-10 * begin);
}

INSTANTIATE_TEST_SUITE_P(Curves, SplineThrough,
                         testing::Values(bend, std::vector<Vec<2>>{{0, 0}, {0.01, 0}, {1, 1}},
                                         std::vector<Vec<2>>{{0, 0}, {1, 0.5}, {0.02, 0.02}}));

/// Through n vertices of a circle: length and places err by n^-4.
TEST(Splines, ApproachACircleInFourthOrder) {
  std::vector<double> errors;
  for (const int n : {8, 16, 32}) {
    std::vector<Vec<2>> vertices;
    for (int k = 0; k < n; ++k) vertices.push_back({std::cos(2 * pi * k / n), std::sin(2 * pi * k / n)});
    vertices.push_back(vertices.front());
    const Curve circle = spline(vertices);
    double error = std::abs(circle.length() / (2 * pi) - 1);
    for (const Vec<2>& at : seeds(circle, 100, {}).places) {
      error = std::max(error, std::abs(std::hypot(at[0], at[1]) - 1));
    }
    errors.push_back(error);
  }
  EXPECT_LT(errors[0], 2e-3);
  EXPECT_GT(std::log2(errors[0] / errors[1]), 3.8);
  EXPECT_GT(std::log2(errors[1] / errors[2]), 3.8);
}

}  // namespace
}  // namespace tether::test
