// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/kernels.hpp"

#include <gtest/gtest.h>

namespace tether {
namespace {

constexpr std::array<double, 5> places_in_cell{0, 0.1, 0.37, 0.5, 1};
constexpr std::array<double, 4> node{-1, 0, 1, 2};  // where they stand, in cells from the one before the place

/// sum_k f_k node_k^power.
double moment(const std::array<double, 4>& f, int power) {
  double sum = 0;
  for (std::size_t k = 0; k < 4; ++k) sum += f[k] * (power == 0 ? 1 : power == 1 ? node[k] : node[k] * node[k]);
  return sum;
}

TEST(CubicWeights, SumIsOneAndLinearFieldsAreReproduced) {
  for (const double r : places_in_cell) {
    EXPECT_NEAR(moment(cubic_weights(r), 0), 1, 1e-15);
    EXPECT_NEAR(moment(cubic_weights(r), 1), r, 1e-15);
    EXPECT_NEAR(moment(cubic_weights(r), 2), r * r + 1.0 / 3, 1e-14);  // the kernel's own variance is a third
  }
}

TEST(CubicWeights, ValuesAtANodeAndInTheMiddle) {
  const auto at_node = cubic_weights(0), middle = cubic_weights(0.5);
  EXPECT_NEAR(at_node[0], 1.0 / 6, 1e-16);
  EXPECT_NEAR(at_node[1], 4.0 / 6, 1e-16);
  EXPECT_NEAR(at_node[2], 1.0 / 6, 1e-16);
  EXPECT_EQ(at_node[3], 0);
  EXPECT_NEAR(middle[0], 1.0 / 48, 1e-16);
  EXPECT_NEAR(middle[1], 23.0 / 48, 1e-15);
  EXPECT_EQ(middle[1], middle[2]);
  EXPECT_EQ(middle[0], middle[3]);
}

TEST(CubicWeights, MeetWithTheirSlopesWhereAPointChangesCells) {
  const auto end = cubic_weights(1), begin = cubic_weights(0), end_slope = cubic_slopes(1), slope = cubic_slopes(0);
  EXPECT_EQ(end[0], 0);
  EXPECT_EQ(end_slope[0], 0);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(end[k + 1], begin[k], 1e-15);
    EXPECT_NEAR(end_slope[k + 1], slope[k], 1e-15);
  }
}

TEST(CubicSlopes, GradientsOfLinearAndQuadraticFields) {
  for (const double r : places_in_cell) {
    EXPECT_NEAR(moment(cubic_slopes(r), 0), 0, 1e-15);
    EXPECT_NEAR(moment(cubic_slopes(r), 1), 1, 1e-15);
    EXPECT_NEAR(moment(cubic_slopes(r), 2), 2 * r, 1e-14);
  }
}

/// A difference quotient of a cubic errs by its third derivative, 3 at the most, times step^2 / 6.
TEST(CubicSlopes, AreTheSlopesOfTheWeights) {
  const double step = 1e-4;
  for (const double r : places_in_cell) {
    const auto behind = cubic_weights(r + step), before = cubic_weights(r - step), slope = cubic_slopes(r);
    for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR((behind[k] - before[k]) / (2 * step), slope[k], 1e-8);
  }
}

}  // namespace
}  // namespace tether
