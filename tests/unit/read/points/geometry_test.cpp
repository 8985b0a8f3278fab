// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/points/geometry.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace tether {
namespace {

TEST(PolygonTest, ConvexInEitherOrder) {
  const Polygon left_turning{{0, 4, 1}, {0, 0, 3}}, right_turning{{1, 4, 0}, {3, 0, 0}};
  for (const Polygon& triangle : {left_turning, right_turning}) {
    EXPECT_TRUE(triangle.contains(1.5, 1));
    EXPECT_TRUE(triangle.contains(0.5, 1));
    EXPECT_FALSE(triangle.contains(0.25, 1));  // left of the side from (0, 0) to (1, 3)
    EXPECT_FALSE(triangle.contains(3.25, 1));
    EXPECT_FALSE(triangle.contains(1, -0.5));
    EXPECT_FALSE(triangle.contains(1, 3.5));
  }
}

TEST(PolygonTest, NonConvex) {  // an arrow head, notched from the left
  const Polygon arrow{{0, 4, 0, 2}, {0, 2, 4, 2}};
  EXPECT_TRUE(arrow.contains(3, 2.1));
  EXPECT_TRUE(arrow.contains(0.75, 0.5));
  EXPECT_TRUE(arrow.contains(0.75, 3.5));
  EXPECT_FALSE(arrow.contains(1, 2.1));
  EXPECT_FALSE(arrow.contains(0.25, 1.5));
}

TEST(PolygonTest, SidesThatCrossAreFound) {
  const auto sides = Polygon{{0, 2, 0, 2}, {0, 0, 2, 2}}.crossing();
  ASSERT_TRUE(sides);
  EXPECT_EQ(sides->first, 1U);
  EXPECT_EQ(sides->second, 3U);
  EXPECT_TRUE((Polygon{{0, 4, 4, 1, 1, 3, 0}, {0, 0, 3, 3, -1, 4, 4}}.crossing()));
}

TEST(PolygonTest, SidesThatTouchDoNotCross) {
  EXPECT_FALSE((Polygon{{0, 4, 1}, {0, 0, 3}}.crossing()));
  EXPECT_FALSE((Polygon{{0, 1, 1, 0, 0}, {0, 0, 1, 1, 0}}.crossing()));        // closed by its first vertex
  EXPECT_FALSE((Polygon{{0, 2, 4, 4, 2, 0}, {0, 1, 0, 2, 1, 2}}.crossing()));  // pinched to a point in the middle
  EXPECT_FALSE((Polygon{
      {0, 3, 3, 0, 0, 1, 1, 2, 2, 1, 1, 0},  // a ring, cut open along a seam
      {0, 0, 3, 3, 1, 1, 2, 2, 1, 1, 1,
       1}}.crossing()));
}

TEST(PolygonTest, EvenOddWhereSidesCross) {  // a bow tie
  const Polygon tie{{0, 2, 2, 0}, {0, 2, 0, 2}};
  EXPECT_TRUE(tie.contains(0.5, 1.25));
  EXPECT_TRUE(tie.contains(1.5, 0.75));
  EXPECT_FALSE(tie.contains(1, 0.5));
  EXPECT_FALSE(tie.contains(1, 1.5));
}

TEST(PolygonTest, HoldsNoPlaceThatIsNotANumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Polygon square{{0, 1, 1, 0}, {0, 0, 1, 1}};
  EXPECT_FALSE(square.contains(nan, 0.5));
  EXPECT_FALSE(square.contains(0.5, nan));
}

int holders(const std::vector<Polygon>& polygons, double x, double y) {
  int count = 0;
  for (const Polygon& polygon : polygons) count += polygon.contains(x, y) ? 1 : 0;
  return count;
}

TEST(PolygonTest, FourSquaresShareEdgesAndACorner) {
  const auto square = [](double x, double y) { return Polygon{{x, x + 1, x + 1, x}, {y, y, y + 1, y + 1}}; };
  const std::vector<Polygon> four{square(0, 0), square(1, 0), square(0, 1), square(1, 1)};
  for (double t = 0.125; t < 2; t += 0.125) {
    EXPECT_EQ(holders(four, 1, t), 1) << t;
    EXPECT_EQ(holders(four, t, 1), 1) << t;
  }
}

/// Both halves see the shared edge from its other end: their crossings must round alike.
TEST(PolygonTest, TwoHalvesOfASquareShareItsDiagonal) {
  const std::vector<Polygon> halves{{{0, 1, 0}, {0, 1, 1}}, {{0, 1, 1}, {0, 0, 1}}};
  for (int k = 0; k < 40; ++k) EXPECT_EQ(holders(halves, (k + 0.5) / 40, (k + 0.5) / 40), 1) << k;
}

/// The edge runs from (a/20, 0) to (b/20, 1).
int places_not_held_once(int a, int b) {
  const double low = a * 0.05, high = b * 0.05;
  const std::vector<Polygon> two{{{0, low, high, 0}, {0, 0, 1, 1}}, {{low, 1, 1, high}, {0, 0, 1, 1}}};
  int wrong = 0;
  for (int k = 0; k < 1600; ++k) wrong += holders(two, (k % 40 + 0.5) / 40, (k / 40 + 0.5) / 40) != 1 ? 1 : 0;
  return wrong;
}

TEST(PolygonTest, TwoPolygonsShareASlantedEdge) {
  int wrong = 0;
  for (int a = 0; a <= 20; ++a) {
    for (int b = 0; b <= 20; ++b) wrong += places_not_held_once(a, b);
  }
  EXPECT_EQ(wrong, 0);
}

TEST(EllipseTest, HoldsWhatIsInsideWithoutItsRim) {
  const Ellipse ellipse{1, -2, 2, 0.5};
  EXPECT_TRUE(ellipse.contains(1, -2));
  EXPECT_TRUE(ellipse.contains(2.99, -2));
  EXPECT_TRUE(ellipse.contains(1, -1.51));
  EXPECT_FALSE(ellipse.contains(3, -2));
  EXPECT_FALSE(ellipse.contains(1, -1.5));
  EXPECT_FALSE(ellipse.contains(2.6, -1.7));
  EXPECT_TRUE(ellipse.contains(2.1, -1.65));
}

TEST(EllipseTest, AHalfAxisOfZeroHoldsNothing) {
  EXPECT_FALSE((Ellipse{0, 0, 0, 1}.contains(0, 0)));
  EXPECT_FALSE((Ellipse{0, 0, 1, 0}.contains(0, 0)));
  EXPECT_FALSE(Ellipse{}.contains(0, 0));
}

TEST(RegionShapeTest, InsideThePolygonAndTheOuterButNotTheInnerEllipse) {
  const RegionShape ring{{{0, 4, 4, 0}, {0, 0, 4, 4}}, {0, 0, 3, 3}, {0, 0, 1, 2}};
  EXPECT_TRUE(ring.contains(1.5, 0.5));
  EXPECT_TRUE(ring.contains(0.5, 2.5));
  EXPECT_FALSE(ring.contains(0.5, 0.5));   // inside the inner one
  EXPECT_FALSE(ring.contains(2.5, 2.5));   // outside the outer one
  EXPECT_FALSE(ring.contains(1.5, -0.5));  // outside the polygon
}

}  // namespace
}  // namespace tether
