// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/boxes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tether {
namespace {

/// 4 x 3 cells of .5 x .25 from (1, -2): all places below are exact in binary.
const BackgroundGrid grid(5, 4, 1, 3, -2, -1.25);

/// Places on an edge count as a hair inside: see Locator::edge.
void expect_place(double x, double y, const CellPlace& expected) {
  const CellPlace at = Locator(grid).locate(x, y);
  EXPECT_EQ(at.i, expected.i) << x << ", " << y;
  EXPECT_EQ(at.j, expected.j) << x << ", " << y;
  EXPECT_EQ(at.r, Locator::inside(expected.r)) << x << ", " << y;
  EXPECT_EQ(at.s, Locator::inside(expected.s)) << x << ", " << y;
}

TEST(BackgroundGridTest, CountsNodesAndCells) {
  EXPECT_EQ(grid.dx, 0.5);
  EXPECT_EQ(grid.dy, 0.25);
  EXPECT_EQ(grid.nodes(), 20u);
  EXPECT_EQ(grid.cells(), 12u);
  EXPECT_EQ(grid.cells_x(), 4);
  EXPECT_EQ(grid.cells_y(), 3);
}

TEST(BackgroundGridTest, CountsBeyondTheRangeOfInt) {
  const BackgroundGrid large(100001, 100001, 0, 1, 0, 1);
  EXPECT_EQ(large.nodes(), 10000200001u);
  EXPECT_EQ(large.cells(), 10000000000u);
}

TEST(BackgroundGridTest, ContainsItsEdgesAndNothingBeyond) {
  for (const double x : {1.0, 2.1, 3.0}) {
    for (const double y : {-2.0, -1.6, -1.25}) EXPECT_TRUE(grid.contains(x, y));
  }
  EXPECT_FALSE(grid.contains(std::nextafter(1.0, 0.0), -1.5));
  EXPECT_FALSE(grid.contains(std::nextafter(3.0, 4.0), -1.5));
  EXPECT_FALSE(grid.contains(2, std::nextafter(-2.0, -3.0)));
  EXPECT_FALSE(grid.contains(2, std::nextafter(-1.25, 0.0)));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(grid.contains(nan, -1.5));
  EXPECT_FALSE(grid.contains(2, nan));
}

TEST(Locate, InsideACell) { expect_place(1.625, -1.6875, {1, 1, 0.25, 0.25}); }

TEST(Locate, AnInnerEdgeBelongsToTheCellThatBeginsThere) {
  expect_place(1.5, -1.625, {1, 1, 0, 0.5});
  expect_place(1.25, -1.75, {0, 1, 0.5, 0});
  expect_place(2.0, -1.5, {2, 2, 0, 0});
}

TEST(Locate, TheRightAndTheTopEdgeBelongToTheLastCell) {
  expect_place(3, -1.875, {3, 0, 1, 0.5});
  expect_place(1.25, -1.25, {0, 2, 0.5, 1});
}

TEST(Locate, TheFourCorners) {
  expect_place(1, -2, {0, 0, 0, 0});
  expect_place(3, -2, {3, 0, 1, 0});
  expect_place(3, -1.25, {3, 2, 1, 1});
  expect_place(1, -1.25, {0, 2, 0, 1});
}

TEST(Locate, OnlyTheLastHairOfACellIsMoved) {
  EXPECT_EQ(Locator::inside(0), 1e-12);
  EXPECT_EQ(Locator::inside(1), 1 - 1e-12);
  EXPECT_EQ(Locator::inside(2e-12), 2e-12);
  EXPECT_EQ(Locator::inside(0.25), 0.25);
}

/// With a side of .1 the divisions round: the place must come back whichever cell it is given to.
TEST(Locate, GivesThePlaceBackAtEveryNodeOfARoundedGrid) {
  const BackgroundGrid tenths(31, 31, 0.3, 3.3, -0.7, 2.3);
  const Locator locator(tenths);
  for (int k = 0; k <= 30; ++k) {
    const double x = std::min(0.3 + k * 0.1, 3.3), y = std::min(-0.7 + k * 0.1, 2.3);
    const CellPlace at = locator.locate(x, y);
    EXPECT_TRUE(at.i >= 0 && at.i < 30 && at.j >= 0 && at.j < 30);
    EXPECT_TRUE(at.r >= 0 && at.r < 1 + 1e-13 && at.s >= 0 && at.s < 1 + 1e-13);
    EXPECT_NEAR(tenths.x0 + (at.i + at.r) * tenths.dx, x, 2e-13);
    EXPECT_NEAR(tenths.y0 + (at.j + at.s) * tenths.dy, y, 2e-13);
  }
}

TEST(Locate, LowerLeftNodeOfACell) {
  const Locator locator(grid);
  EXPECT_EQ(locator.lower_left_node({0, 0, 0, 0}), 0u);
  EXPECT_EQ(locator.lower_left_node({3, 0, 0, 0}), 3u);
  EXPECT_EQ(locator.lower_left_node({1, 2, 0, 0}), 11u);
}

TEST(Locate, LowerLeftNodeBeyondTheRangeOfInt) {
  const Locator locator(BackgroundGrid(100001, 100001, 0, 1, 0, 1));
  EXPECT_EQ(locator.lower_left_node({7, 99999, 0, 0}), 10000000006u);
}

}  // namespace
}  // namespace tether
