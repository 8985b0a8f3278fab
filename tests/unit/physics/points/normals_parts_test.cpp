// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "physics/points/normals_cells.hpp"
#include "physics/points/normals_membrane.hpp"

namespace tether::mpm {
namespace {

/// Numbers without a pattern, from -1 to 1.
double number(int k) { return std::sin(12.9898 * k + 0.3 * k * k); }

// Unknowns 0 1 2 in a chain, 3 and 4 joined to 0 and to 2: rows of different lengths.
TEST(ProfileMatrixTest, SolvesWithinItsProfile) {
  const std::vector<std::size_t> first{0, 0, 1, 0, 2};
  ProfileMatrix A;
  for (int round = 0; round < 2; ++round) {  // the second time in the memory of the first
    A.shape(first);
    std::vector<double> x(5), b(5, 0.0);
    for (std::size_t i = 0; i < 5; ++i) x[i] = 3 * number(static_cast<int>(i) + 40);
    for (std::size_t i = 0; i < 5; ++i) {
      for (std::size_t j = first[i]; j <= i; ++j) {
        const double a = i == j ? 4 : number(static_cast<int>(7 * i + j));
        A.at(i, j) += a;
        b[i] += a * x[j];
        if (i != j) b[j] += a * x[i];
      }
    }
    A.factor();
    A.solve(b);
    for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(b[i], x[i], 1e-14);
  }
}

TEST(LeastSquaresTest, FindsWhatAllRowsAgreeOn) {
  LeastSquares<4> rows;
  const std::array<double, 4> x{1, -2, 0.5, 3};
  for (int k = 0; k < 9; ++k) {
    std::array<double, 4> row;
    double value = 0;
    for (std::size_t j = 0; j < 4; ++j) row[j] = number(4 * k + static_cast<int>(j)), value += row[j] * x[j];
    rows.add(row, value, 0.1 + k);
  }
  for (std::size_t j = 0; j < 4; ++j) EXPECT_NEAR(rows.solution()[j], x[j], 1e-13);
}

// x = 1, x = 4 of twice the weight: the mean by squares of weights, (1 + 4 4) / (1 + 4).
TEST(LeastSquaresTest, WeighsRowsThatDisagree) {
  LeastSquares<1> rows;
  rows.add({1}, 1);
  rows.add({1}, 4, 2);
  EXPECT_NEAR(rows.solution()[0], 17.0 / 5, 1e-15);
}

// Colours 1e4 times less certain than others come out to 1e-10 all the same: with normal equations it would be 1e-8.
TEST(LeastSquaresTest, KeepsTheDigitsThatNormalEquationsLose) {
  LeastSquares<2> rows;
  for (const double t : {0.0, 1.0}) rows.add({1, 1e-6 * t}, 2 + 3e-6 * t);
  EXPECT_NEAR(rows.solution()[0], 2, 1e-15);
  EXPECT_NEAR(rows.solution()[1], 3, 1e-9);
}

TEST(NearestLineTest, OfPointsAtAnyAngle) {
  for (double angle = 0; angle < 3.2; angle += 0.1) {
    std::vector<LocalPlace> places;
    const double c = std::cos(angle), s = std::sin(angle);
    for (const double d : {-0.3, 0.1, 0.2}) places.push_back({0.5 + d * c / 2, 0.4 + d * s / 0.5});
    const NearestLine line = nearest_line(places, 2, 0.5);
    EXPECT_NEAR(line.nx * c + line.ny * s, 0, 1e-14);
    EXPECT_NEAR(std::hypot(line.nx, line.ny), 1, 1e-15);
    EXPECT_NEAR(line.spread, (0.09 + 0.01 + 0.04) / 3 / 0.25, 1e-14);
    EXPECT_FALSE(line.one_place());
  }
}

TEST(NearestLineTest, OfOneSpotOrARoundHeapIsSound) {
  const std::vector<LocalPlace> spot{{0.2, 0.7}, {0.2, 0.7}}, heap{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  EXPECT_TRUE(nearest_line(spot, 1, 1).one_place());
  for (const auto& places : {spot, heap}) {
    const NearestLine line = nearest_line(places, 1, 1);
    EXPECT_EQ(std::hypot(line.nx, line.ny), 1);
  }
}

// The extra point stands a quarter of the shorter side off the line, in the cell wherever the line leaves room.
TEST(ExtraPointTest, StandsOffTheLineInTheCell) {
  for (int k = 0; k < 200; ++k) {
    NearestLine line;
    line.middle = {0.5 + 0.49 * number(k), 0.5 + 0.49 * number(k + 500)};
    line.nx = std::cos(0.1 * k), line.ny = std::sin(0.1 * k);
    const ExtraPoint extra = extra_point(line, 2, 0.5);
    const double x = 2 * (extra.at.r - line.middle.r), y = 0.5 * (extra.at.s - line.middle.s);
    EXPECT_NEAR(x * line.nx + y * line.ny, extra.height * 0.5, 1e-14);
    EXPECT_NEAR(std::abs(extra.height), 0.25, 1e-15);
    const auto out = [](double r) { return std::max({0.0, -r, r - 1}); };
    EXPECT_LT(out(extra.at.r) + out(extra.at.s), 0.25);
  }
}

TEST(ColorsTest, BendsAndTwistsVanishForWhatTheyNameTheOpposite) {
  for (const auto& bend : LinearColor::bends) EXPECT_EQ(bend[0] + bend[1] + bend[2] + bend[3], 0);
  const auto of = [](const QuadraticColor::Row& row, auto color) {  // of colours at centres -1 .. 1
    double sum = 0;
    for (std::size_t k = 0; k < 9; ++k)
      sum += row[k] * color(static_cast<double>(k % 3) - 1, static_cast<double>(k / 3) - 1);
    return sum;
  };
  for (const auto& bend : QuadraticColor::bends) {
    EXPECT_NEAR(of(bend, [](double r, double s) { return 2 + 3 * r - 5 * s; }), 0, 1e-14);
  }
  for (const auto& twist : QuadraticColor::twists) {
    EXPECT_NEAR(of(twist, [](double r, double s) { return 2 + 3 * r - 5 * s + 7 * r * s + 11 * r * r - s * s; }), 0,
                1e-13);
  }
}

/// A central difference of the colour, exact for its quadratics and bilinears but for rounding.
template <class Color>
void expect_gradient_is_slope() {
  typename Color::Row colors;
  for (std::size_t k = 0; k < Color::count; ++k) colors[k] = number(static_cast<int>(k));
  const auto color = [&](double r, double s) {
    const auto weights = Color::weights({r, s});
    double sum = 0;
    for (std::size_t k = 0; k < Color::count; ++k) sum += weights[k] * colors[k];
    return sum;
  };
  const double step = 1e-3;
  for (const double r : {0.0, 0.3, 1.0}) {
    for (const double s : {0.1, 0.8}) {
      const Pair gradient = color_gradient<Color>(colors, {r, s});
      EXPECT_NEAR(gradient[0], (color(r + step, s) - color(r - step, s)) / (2 * step), 1e-12);
      EXPECT_NEAR(gradient[1], (color(r, s + step) - color(r, s - step)) / (2 * step), 1e-12);
    }
  }
}

TEST(ColorsTest, GradientsAreSlopes) {
  expect_gradient_is_slope<LinearColor>();
  expect_gradient_is_slope<QuadraticColor>();
}

TEST(GoTogether, RefusesGradientsThatTurnRoundOrDieAway) {
  EXPECT_TRUE(go_together(std::vector<Pair>{pair(1, 0), pair(0.7, 0.7), pair(0.7, -0.7)}));
  EXPECT_FALSE(go_together(std::vector<Pair>{pair(1, 0), pair(-1, 0)}));
  EXPECT_FALSE(go_together(std::vector<Pair>{pair(1, 0), pair(0, 0.01), pair(1, 0)}));
  EXPECT_FALSE(go_together(std::vector<Pair>{pair(std::nan(""), 0)}));
}

}  // namespace
}  // namespace tether::mpm
