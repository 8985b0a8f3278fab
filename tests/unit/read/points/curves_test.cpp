// SPDX-License-Identifier: GPL-3.0-or-later
#include "unit/read/points/curves_support.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "unit/total.hpp"

namespace tether::test {
namespace {

using std::numbers::pi;

TEST(Polylines, PointsStandInTheMiddleOfEqualPieces) {
  const Curve line = polyline({{1, 2}, {4, 6}});
  EXPECT_EQ(line.length(), 5);
  const Seeds points = seeds(line, 5, {});
  ASSERT_EQ(points.places.size(), 5u);
  for (std::size_t k = 0; k < 5; ++k) {
    const double s = static_cast<double>(k) + 0.5;
    expect_near(points.places[k], {1 + 0.6 * s, 2 + 0.8 * s}, 1e-15);
    EXPECT_EQ(points.pieces[k], 1);
  }
}

/// Three sides of lengths 3, 4, 5: a piece runs on round a corner.
TEST(Polylines, PiecesRunRoundCorners) {
  const Curve sides = polyline({{0, 0}, {3, 0}, {3, 4}, {0, 0}});
  EXPECT_EQ(sides.length(), 12);
  EXPECT_TRUE(is_closed(sides));
  const Seeds points = seeds(sides, 6, {});
  const std::vector<Vec<2>> expected{{1, 0}, {3, 0}, {3, 2}, {3, 4}, {1.8, 2.4}, {0.6, 0.8}};
  for (std::size_t k = 0; k < 6; ++k) expect_near(points.places[k], expected[k], 1e-15);
}

TEST(Polylines, EndsAreMetExactly) {
  const Curve line = polyline({{0.1, 0.7}, {1.0 / 3, 2.0 / 7}});
  EXPECT_EQ(line.at(line.length())[0], 1.0 / 3);
  EXPECT_EQ(line.at(line.length())[1], 2.0 / 7);
  EXPECT_EQ(line.at(-1)[0], 0.1);
  EXPECT_EQ(line.at(99)[1], 2.0 / 7);
}

TEST(Arcs, PointsStandAtEqualAngles) {
  for (const auto& [from, to] : {std::pair{0.0, 90.0}, {30.0, 200.0}, {200.0, 30.0}, {-90.0, 270.0}}) {
    const Curve arc = ellipse_arc({1, -2}, 3, 3, from, to);
    EXPECT_NEAR(arc.length(), 3 * pi * std::abs(to - from) / 180, 1e-13);
    const Seeds points = seeds(arc, 7, {});
    for (std::size_t k = 0; k < 7; ++k) {
      const double angle = pi / 180 * (from + (to - from) * (static_cast<double>(k) + 0.5) / 7);
      expect_near(points.places[k], {1 + 3 * std::cos(angle), -2 + 3 * std::sin(angle)}, 1e-12);
    }
  }
}

/// So that a membrane that ends on a wall or on the axis does not end behind it by a rounding.
TEST(Arcs, QuartersOfATurnEndExactlyOnTheAxes) {
  EXPECT_EQ(ellipse_arc({0, 0}, 0.7, 0.7, 0, 90).last()[0], 0);
  EXPECT_EQ(ellipse_arc({0, 0}, 0.7, 0.3, 0, 180).last()[1], 0);
  EXPECT_EQ(ellipse_arc({0, 0}, 0.7, 0.3, 180, 360).last()[1], 0);
  EXPECT_EQ(ellipse_arc({0, 0}, 0.7, 0.3, -90, 90).first()[0], 0);
  EXPECT_EQ(ellipse_arc({0, 0}, 0.7, 0.3, 0, -270).last()[0], 0);
}

class EllipseOfAxes : public testing::TestWithParam<std::pair<double, double>> {};

/// Arc length of the ellipse between the parameters u and w [rad].
double ellipse_length(double a, double b, double u, double w) {
  return integral([&](double t) { return std::hypot(a * std::sin(t), b * std::cos(t)); }, u, w);
}

TEST_P(EllipseOfAxes, PointsStandAtEqualArcLengths) {
  const auto [a, b] = GetParam();
  const Curve arc = ellipse_arc({0, 0}, a, b, 20, 170);
  const Seeds points = seeds(arc, 9, {});
  const double length = ellipse_length(a, b, pi / 9, pi * 17 / 18);
  EXPECT_NEAR(arc.length(), length, 1e-10 * length);
  double u = pi / 9;
  for (std::size_t k = 0; k < 9; ++k) {
    const double w = std::atan2(points.places[k][1] / b, points.places[k][0] / a);
    EXPECT_NEAR(ellipse_length(a, b, u, w), length / (k == 0 ? 18 : 9), 1e-10 * length) << k;
    u = w;
  }
}

INSTANTIATE_TEST_SUITE_P(Curves, EllipseOfAxes,
                         testing::Values(std::pair{1.0, 1.0}, std::pair{2.0, 1.0}, std::pair{1.0, 2.0},
                                         std::pair{0.290, 0.1575}, std::pair{30.0, 1.0}, std::pair{1.0, 30.0}));

TEST(Ellipses, KnownPerimeter) {  // 4 a E(sqrt(3)/2) of half axes 2 and 1
  EXPECT_NEAR(ellipse_arc({5, 6}, 2, 1, 0, 360).length(), 9.688448220547675, 1e-14);
  EXPECT_NEAR(ellipse_arc({5, 6}, 1, 2, 90, -270).length(), 9.688448220547675, 1e-14);
}

/// As flat as can be it is the line from end to end and back.
TEST(Ellipses, FlatOnes) {
  for (const double b : {1e-6, 1e-9, 1e-12}) {
    const Curve flat = ellipse_arc({0, 0}, 1, b, 0, 360);
    EXPECT_NEAR(flat.length(), 4, 1e-9);
    const Seeds points = seeds(flat, 8, {});
    const std::vector<double> x{0.75, 0.25, -0.25, -0.75, -0.75, -0.25, 0.25, 0.75};
    for (std::size_t k = 0; k < 8; ++k) EXPECT_NEAR(points.places[k][0], x[k], 1e-9) << b;
  }
}

/// No chord is longer than its arc, not even about the ends of a flat ellipse, where it turns within b^2 / a.
TEST(Ellipses, ChordsAreNoLongerThanTheirArcs) {
  for (const double b : {0.5, 1e-3, 1e-6}) {
    const Curve ellipse = ellipse_arc({0.3, 0.2}, b, 1, 33, 388);
    const double piece = ellipse.length() / 4000;
    double sum = 0, longest = 0;
    for (int k = 0; k < 4000; ++k) {
      const double chord = distance(ellipse.at(k * piece), ellipse.at((k + 1) * piece));
      sum += chord, longest = std::max(longest, chord);
    }
    EXPECT_LT(longest, piece + 1e-12 * ellipse.length()) << b;
    EXPECT_NEAR(sum, ellipse.length(), 1e-3 * ellipse.length()) << b;
  }
}

TEST(Ellipses, RunClockwiseWhereToIsBelowFrom) {
  const Seeds forth = seeds(ellipse_arc({0, 0}, 2, 1, 10, 130), 5, {});
  const Seeds back = seeds(ellipse_arc({0, 0}, 2, 1, 130, 10), 5, {});
  for (std::size_t k = 0; k < 5; ++k) expect_near(forth.places[k], back.places[4 - k], 1e-12);
}

TEST(Joined, RunsThroughAllItsCurves) {
  const Curve chain =
      joined({polyline({{0, 0}, {2, 0}}), ellipse_arc({2, 1}, 1, 1, -90, 90), polyline({{2, 2}, {0, 2}})});
  EXPECT_NEAR(chain.length(), 4 + pi, 1e-14);
  expect_near(chain.at(2), {2, 0}, 1e-15);
  expect_near(chain.at(2 + pi / 2), {3, 1}, 1e-13);
  expect_near(chain.at(3 + pi), {1, 2}, 1e-13);
  EXPECT_FALSE(is_closed(chain));
  EXPECT_TRUE(is_closed(joined({chain, polyline({{0, 2}, {0, 0}})})));
}

TEST(Joined, IsClosedToAPartIn1e9OfItsLength) {
  const auto with_gap = [](double gap) { return polyline({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, gap}}); };
  EXPECT_TRUE(is_closed(with_gap(3.9e-9)));
  EXPECT_FALSE(is_closed(with_gap(4.1e-9)));
}

/// A line of length 3: two points at the ends, one at an end, none.
TEST(SeedsAtEnds, StandThereWithHalfAPiece) {
  const Curve line = polyline({{0, 0}, {3, 0}});
  const auto places = [&](std::size_t n, EndPoints ends) {
    std::vector<double> x;
    for (const Vec<2>& at : seeds(line, n, ends).places) x.push_back(at[0]);
    return x;
  };
  EXPECT_EQ(places(4, {true, true}), (std::vector<double>{0, 1, 2, 3}));
  EXPECT_EQ(places(2, {true, false}), (std::vector<double>{0, 2}));
  EXPECT_EQ(places(2, {false, true}), (std::vector<double>{1, 3}));
  EXPECT_EQ(places(3, {}), (std::vector<double>{0.5, 1.5, 2.5}));
  EXPECT_EQ(seeds(line, 4, {true, true}).pieces, (std::vector<double>{0.5, 1, 1, 0.5}));
  EXPECT_EQ(seeds(line, 2, {true, false}).pieces, (std::vector<double>{1, 2}));
  EXPECT_EQ(seeds(line, 2, {false, true}).pieces, (std::vector<double>{2, 1}));
}

TEST(SeedsAtEnds, MeetTheEndsOfCurvesExactlyAndShareTheWholeLength) {
  const Curve arc = ellipse_arc({0.3, 0.7}, 1.1, 0.4, 10, 111);
  for (const EndPoints ends : {EndPoints{}, EndPoints{true, false}, EndPoints{false, true}, EndPoints{true, true}}) {
    const Seeds points = seeds(arc, 1001, ends);
    EXPECT_NEAR(total(points.pieces), arc.length(), 1e-13);
    if (ends.first) expect_near(points.places.front(), arc.first(), 0);
    if (ends.last) expect_near(points.places.back(), arc.last(), 0);
  }
}

TEST(SeedCount, IsTheNearestNumberThatFits) {
  const Curve line = polyline({{0, 0}, {3, 0}});
  EXPECT_EQ(seed_count(line, 1, {}), 3);
  EXPECT_EQ(seed_count(line, 1.1, {}), 3);
  EXPECT_EQ(seed_count(line, 0.8, {}), 4);
  EXPECT_EQ(seed_count(line, 1, {true, true}), 4);
  EXPECT_EQ(seed_count(line, 2, {true, false}), 2);
  EXPECT_EQ(seed_count(line, 2, {false, true}), 2);
  EXPECT_EQ(seed_count(line, 9, {}), 0);
  EXPECT_EQ(seed_count(line, 1e-300, {}), 3e300);
}

}  // namespace
}  // namespace tether::test
