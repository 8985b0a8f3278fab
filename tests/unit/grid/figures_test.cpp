// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/figures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

// Which figures in space have a place in common.

namespace tether {
namespace {

constexpr double little = 1e-6;

TEST(Figures, ABallMeetsABoxAtItsSideEdgeAndCorner) {
  const Box<3> box{{0, 0, 0}, {1, 2, 3}};
  for (const double off : {-little, little}) {
    const auto meets = [&](const Vec<3>& middle, double radius) {
      return meet(Ellipsoid{middle, {radius - off, radius - off, radius - off}}, box);
    };
    EXPECT_EQ(meets({1.5, 1, 1}, 0.5), off < 0) << "side";
    EXPECT_EQ(meets({1.3, 2.4, 1}, 0.5), off < 0) << "edge";
    EXPECT_EQ(meets({1.2, 2.3, 3.6}, 0.7), off < 0) << "corner";
    EXPECT_TRUE(meets({0.5, 0.5, 0.5}, 0.1)) << "within";
  }
}

/// In units of its half axes, (0.5, 1, 0.25), the corner (1, 2, 3) is (3, 4, 0) from its middle: 5 half axes.
TEST(Figures, AnEllipsoidMeetsABoxByItsOwnAxes) {
  for (const double off : {-little, little}) {
    const double grow = 5 - off;
    EXPECT_EQ(meet(Ellipsoid{{2.5, 6, 2}, {0.5 * grow, grow, 0.25 * grow}}, Box<3>{{0, 0, 0}, {1, 2, 3}}), off < 0);
  }
}

TEST(Figures, BallsMeetAtTheSumOfTheirRadii) {
  const Ellipsoid one{{1, 2, 3}, {0.5, 0.5, 0.5}};
  for (const double off : {-little, little}) {
    const double distance = (0.5 + 0.2 + off) / 3;
    EXPECT_EQ(meet(one, Ellipsoid{{1 + distance, 2 + 2 * distance, 3 - 2 * distance}, {0.2, 0.2, 0.2}}), off < 0);
  }
  EXPECT_TRUE(meet(one, Ellipsoid{{1.1, 2, 3}, {0.1, 0.1, 0.1}})) << "within";
}

/// Grows one until it touches a place on the other's surface whose normals are opposite.
TEST(Figures, EllipsoidsMeetWhereTheirNormalsAreOpposite) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-1, 1), axis(0.1, 2);
  for (int k = 0; k < 100; ++k) {
    Vec<3> way{any(random), any(random), any(random)}, a{}, b{};
    for (std::size_t i = 0; i < 3; ++i) a[i] = axis(random), b[i] = axis(random);
    double p = 0, q = 0;  // of the supporting planes across the way
    for (std::size_t i = 0; i < 3; ++i) p += std::pow(a[i] * way[i], 2), q += std::pow(b[i] * way[i], 2);
    Vec<3> middle{};
    for (std::size_t i = 0; i < 3; ++i) middle[i] = (a[i] * a[i] / std::sqrt(p) + b[i] * b[i] / std::sqrt(q)) * way[i];
    for (const double grow : {1 - little, 1 + little}) {
      Ellipsoid other{middle, b};
      for (double& half : other.half) half *= grow;
      EXPECT_EQ(meet(Ellipsoid{{}, a}, other), grow > 1) << k;
      EXPECT_EQ(meet(other, Ellipsoid{{}, a}), grow > 1) << k;
    }
  }
}

}  // namespace
}  // namespace tether
