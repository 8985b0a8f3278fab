// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "physics/points/normals.hpp"

// Grid normals of bodies for contact (A.1.4), on 10 x 10 unit cells.

namespace tether::mpm {
namespace {

struct BodyOfPoints {
  std::vector<double> x, y;
  void add(double at_x, double at_y) { x.push_back(at_x), y.push_back(at_y); }
  std::vector<std::size_t> slots() const {
    std::vector<std::size_t> all(x.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return all;
  }
};

/// Points in the middles of sub-cells, kept where `in` holds.
template <class In>
BodyOfPoints body_where(int per_side, const In& in) {
  BodyOfPoints body;
  for (int b = 0; b < 10 * per_side; ++b) {
    for (int a = 0; a < 10 * per_side; ++a) {
      const double x = (a + 0.5) / per_side, y = (b + 0.5) / per_side;
      if (in(x, y)) body.add(x, y);
    }
  }
  return body;
}

constexpr Walls open_walls{Wall::open, Wall::open, Wall::open, Wall::open};

BodyNormals normals_of(const BodyOfPoints& body, const Walls& walls = open_walls) {
  BodyNormals normals(BackgroundGrid(11, 11, 0, 10, 0, 10), walls);
  normals.take({body.x, body.y}, body.slots());
  return normals;
}

void expect_normal(const BodyNormals& normals, int i, int j, double x, double y) {
  const Vec<2> n = normals.outward(j * 11 + i);
  EXPECT_NEAR(n[0], x, 1e-12) << i << ", " << j;
  EXPECT_NEAR(n[1], y, 1e-12) << i << ", " << j;
}

// A bar over x 3..7, y 2..8: its faces' normals on the face and on the nodes beside it, inside and out.
TEST(BodyNormalsTest, OfABarsFaces) {
  for (const int per_side : {1, 2, 4}) {
    const auto normals =
        normals_of(body_where(per_side, [](double x, double y) { return x > 3 && x < 7 && y > 2 && y < 8; }));
    for (const int j : {4, 5, 6}) {
      for (const int i : {2, 3, 4}) expect_normal(normals, i, j, -1, 0);
      for (const int i : {6, 7, 8}) expect_normal(normals, i, j, 1, 0);
      expect_normal(normals, 5, j, 0, 0);
    }
    expect_normal(normals, 5, 2, 0, -1);
    expect_normal(normals, 5, 8, 0, 1);
    const double half = std::sqrt(0.5);
    expect_normal(normals, 3, 2, -half, -half);
    expect_normal(normals, 7, 8, half, half);
    expect_normal(normals, 0, 5, 0, 0);  // far away there is none
  }
}

TEST(BodyNormalsTest, OfAnEdgeAt45Degrees) {
  const double half = std::sqrt(0.5);
  for (const int per_side : {1, 2, 4}) {
    const auto normals = normals_of(body_where(per_side, [](double x, double y) { return x + y < 9; }));
    for (int i = 3; i <= 6; ++i) {
      expect_normal(normals, i, 9 - i, half, half);
      expect_normal(normals, i, 10 - i, half, half);
    }
  }
}

// In cells twice as wide as high the kernel is not round: five degrees off.
TEST(BodyNormalsTest, OfAnEdgeAt45DegreesInCellsThatAreNotSquare) {
  const BodyOfPoints body = body_where(4, [](double x, double y) { return x + y < 9; });
  BodyNormals normals(BackgroundGrid(11, 21, 0, 10, 0, 10), open_walls);
  normals.take({body.x, body.y}, body.slots());
  for (int i = 3; i <= 6; ++i) {
    const Vec<2> n = normals.outward(2 * (9 - i) * 11 + i);
    EXPECT_NEAR(std::atan2(n[1], n[0]) * 180 / std::numbers::pi, 45, 6);
  }
}

// A row of points at y = 5.5: outward is away from it on both sides. On the row itself there is no outward.
TEST(BodyNormalsTest, OfAMembranesTwoSides) {
  BodyOfPoints membrane;
  for (int k = 0; k < 20; ++k) membrane.add(0.5 * (k + 0.5), 5.5);
  const auto normals = normals_of(membrane);
  for (int i = 2; i <= 8; ++i) {
    expect_normal(normals, i, 5, 0, -1);
    expect_normal(normals, i, 6, 0, 1);
  }
  for (double& y : membrane.y) y = 5;
  const auto on_nodes = normals_of(membrane);
  for (int i = 2; i <= 8; ++i) {
    expect_normal(on_nodes, i, 4, 0, -1);
    expect_normal(on_nodes, i, 5, 0, 0);
    expect_normal(on_nodes, i, 6, 0, 1);
  }
}

// A body that lies against mirrors goes on behind them: no normals at the walls but along them. Against open edges it
// ends there.
TEST(BodyNormalsTest, GoOnBehindAMirror) {
  const BodyOfPoints corner = body_where(2, [](double x, double y) { return x < 6 && y < 6; });
  const auto between_mirrors = normals_of(corner, {Wall::symmetry, Wall::open, Wall::axis, Wall::open});
  const auto in_the_open = normals_of(corner);
  const BodyOfPoints across = body_where(2, [](double x, double y) { return x > 4 && y > 4; });
  const auto high = normals_of(across, {Wall::open, Wall::free_slip, Wall::open, Wall::symmetry});
  for (int k = 0; k <= 3; ++k) {
    expect_normal(between_mirrors, 6, k, 1, 0);
    expect_normal(between_mirrors, k, 6, 0, 1);
    expect_normal(between_mirrors, 0, k, 0, 0);
    expect_normal(high, 4, 10 - k, -1, 0);
    expect_normal(high, 10 - k, 4, 0, -1);
    expect_normal(high, 10, 10 - k, 0, 0);
  }
  expect_normal(in_the_open, 0, 3, -1, 0);
  expect_normal(in_the_open, 3, 0, 0, -1);
}

TEST(BodyNormalsTest, ForgetTheBodyBefore) {
  BodyNormals normals(BackgroundGrid(11, 11, 0, 10, 0, 10), open_walls);
  const BodyOfPoints first = body_where(2, [](double x, double) { return x < 3; });
  const BodyOfPoints second = body_where(2, [](double x, double) { return x > 7; });
  normals.take({first.x, first.y}, first.slots());
  expect_normal(normals, 3, 5, 1, 0);
  normals.take({second.x, second.y}, second.slots());
  expect_normal(normals, 3, 5, 0, 0);
  expect_normal(normals, 7, 5, -1, 0);
}

}  // namespace
}  // namespace tether::mpm
