// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "grid/point_finder.hpp"
#include "grid/shapes.hpp"
#include "unit/grid/point_finder_support.hpp"

namespace tether {
namespace {

/// An element of second order whose edge bulges out between its nodes, beyond the box that they span.
TEST(PointFinder, KnowsThatEdgesBulgeBeyondTheirNodes) {
  Mesh mesh{ElementKind::quad9, {}, {0, 1, 2, 3, 4, 5, 6, 7, 8}, {0}, {}};
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 3; ++i) mesh.x.push_back(0.5 * i), mesh.x.push_back(0.5 * j + 0.1 * i * j);
  }
  mesh.x[2 * 7 + 1] = 1.38;  // the middle of the top edge, whose ends are at 1 and 1.4
  const Vec<2> highest = place_in(mesh, 0, {0.56, 1});
  ASSERT_GT(highest[1], 1.43);
  const auto found = PointFinder(mesh).find(highest);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->s[0], 0.56, 1e-12);
  EXPECT_NEAR(found->s[1], 1, 1e-12);
}

/// The nine nodes of a square, moved by up to `by` at random; again until the map is one to one.
Mesh bent_element(double by, std::mt19937& random) {
  std::uniform_real_distribution<double> number(-by, by);
  while (true) {
    Mesh mesh{ElementKind::quad9, {}, {0, 1, 2, 3, 4, 5, 6, 7, 8}, {0}, {}};
    for (int a = 0; a < 9; ++a) {
      const double x = a % 3 - 1 + number(random), y = a / 3 - 1 + number(random);
      mesh.x.push_back(x), mesh.x.push_back(y);
    }
    double least = 1;
    for (int k = 0; k < 441; ++k) {
      const Vec<2> s{0.1 * (k % 21) - 1, 0.1 * (k / 21) - 1};
      least = std::min(least, jacobian_at<ShapesOf<ElementKind::quad9>>(mesh, 0, s).determinant);
    }
    if (least > 0.05) return mesh;
  }
}

/// One node that is not where a parallelogram has it is enough.
TEST(PointFinder, FindsPlacesInElementsBentAtANode) {
  std::mt19937 random(1);
  for (std::size_t a = 0; a < 9; ++a) {
    Mesh mesh = bent_element(0, random);
    mesh.x[2 * a] += 0.1;
    for (const Vec<2>& s : {Vec<2>{0.3, 0.4}, Vec<2>{-0.9, 0.7}, Vec<2>{0.5, -0.8}}) {
      const auto found = PointFinder(mesh).find(place_in(mesh, 0, s));
      ASSERT_TRUE(found);
      EXPECT_LT(distance(found->s, s), 1e-12) << "node " << a;
    }
  }
}

TEST(PointFinder, FindsPlacesInElementsBentALittleAndMuch) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(-1, 1);
  for (const double by : {1e-7, 1e-3, 0.1, 0.4, 0.6}) {
    for (int k = 0; k < 200; ++k) {
      const Mesh mesh = bent_element(by, random);
      const PointFinder finder(mesh);
      for (int i = 0; i < 1000; ++i) {
        const Vec<2> s{number(random), number(random)}, x = place_in(mesh, 0, s);
        const auto found = finder.find(x, i % 2 - 1);
        ASSERT_TRUE(found);
        ASSERT_LT(distance(found->s, s), 1e-12);
      }
    }
  }
}

}  // namespace
}  // namespace tether
