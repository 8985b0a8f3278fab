// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/point_finder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "grid/block_mesh.hpp"
#include "unit/grid/mesh_support.hpp"
#include "unit/grid/point_finder_support.hpp"

namespace tether {
namespace {

Block quadrilateral(const std::array<Vec<2>, 4>& corners, std::array<int, 3> cells, std::array<double, 3> grading) {
  Block block;
  for (std::size_t k = 0; k < 4; ++k) block.edges[k] = straight(corners[k], corners[(k + 1) % 4]);
  block.cells = cells, block.grading = grading;
  return block;
}

constexpr double hole = 0.5, rim = 2;  // radii of the ring

/// Four blocks about a hole, the cells towards it thinner.
std::vector<Block> ring(Vec<2> centre = {0, 0}) {
  std::vector<Block> blocks;
  const auto at = [&](double radius, int quarter) {
    const double angle = std::numbers::pi * (0.25 + 0.5 * quarter);
    return Vec<2>{centre[0] + radius * std::cos(angle), centre[1] + radius * std::sin(angle)};
  };
  for (int q = 0; q < 4; ++q) {
    Block block;
    block.edges = {elliptic(at(rim, q), at(rim, q + 1), centre, rim, rim), straight(at(rim, q + 1), at(hole, q + 1)),
                   elliptic(at(hole, q + 1), at(hole, q), centre, hole, hole), straight(at(hole, q), at(rim, q))};
    block.cells = {3, 5, 1}, block.grading = {1, 0.1, 1};
    blocks.push_back(block);
  }
  return blocks;
}

struct Case {
  const char* name;
  Mesh mesh;
};

std::vector<Case> cases() {
  const std::array<Vec<2>, 4> square{{{-1, 2}, {2, 2}, {2, 4}, {-1, 4}}};
  const std::array<Vec<2>, 4> turned{{{2, 2}, {2, 4}, {-1, 4}, {-1, 2}}};
  const std::array<Vec<2>, 4> sheared{{{0, 0}, {3, 1}, {4, 4}, {1, 3}}};
  const std::array<Vec<2>, 4> skew{{{0, 0}, {3, 1}, {4, 3}, {-1, 2}}};
  std::vector<Case> all;
  for (const ElementKind kind : {ElementKind::quad4, ElementKind::quad9}) {
    all.push_back({"rectangle", meshed({quadrilateral(square, {7, 5, 1}, {1, 1, 1})}, kind)});
    all.push_back({"graded", meshed({quadrilateral(turned, {9, 6, 1}, {50, 0.02, 1})}, kind)});
    all.push_back({"parallelogram", meshed({quadrilateral(sheared, {4, 5, 1}, {3, 1, 1})}, kind)});
    all.push_back({"skew", meshed({quadrilateral(skew, {6, 5, 1}, {1, 4, 1})}, kind)});
    all.push_back({"ring", meshed(ring(), kind)});
    all.push_back({"ring far away", meshed(ring({4000, -300}), kind)});
  }
  return all;
}

double size_of(const Mesh& mesh) {
  double most = 0;
  for (const double x : mesh.x) most = std::max(most, std::abs(x));
  return most;
}

/// Inside and outside by the cross products of the straight edges.
bool inside_straight(const Mesh& mesh, int e, const Vec<2>& x) {
  constexpr std::array<std::array<int, 2>, 4> edges{{{0, 1}, {1, 3}, {3, 2}, {2, 0}}};
  for (const auto& edge : edges) {
    const int* nodes = mesh.element(static_cast<std::size_t>(e));
    const double* a = &mesh.x[2 * static_cast<std::size_t>(nodes[edge[0]])];
    const double* b = &mesh.x[2 * static_cast<std::size_t>(nodes[edge[1]])];
    if ((b[0] - a[0]) * (x[1] - a[1]) - (b[1] - a[1]) * (x[0] - a[0]) < 0) return false;
  }
  return true;
}

TEST(PointFinder, FindsPlacesInsideOfElements) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> number(-0.999, 0.999);
  for (const auto& [name, mesh] : cases()) {
    SCOPED_TRACE(name);
    const PointFinder finder(mesh);
    const auto count = static_cast<int>(mesh.element_count());
    for (int k = 0; k < 60 * count; ++k) {
      const Vec<2> s = k < count ? Vec<2>{0, 0} : Vec<2>{number(random), number(random)};
      const Vec<2> x = place_in(mesh, k % count, s);
      const auto found = finder.find(x);
      ASSERT_TRUE(found);
      ASSERT_EQ(found->element, k % count);
      ASSERT_LT(distance(found->s, s), 1e-10);
      ASSERT_LT(distance(place_in(mesh, found->element, found->s), x), 1e-13 * size_of(mesh));
      for (const int hint : {found->element, 0, count - 1, count, -7}) {
        const auto again = finder.find(x, hint);
        ASSERT_TRUE(again);
        ASSERT_EQ(again->element, found->element);
        ASSERT_EQ(again->s, found->s);
      }
    }
  }
}

/// A node belongs to the lowest of its elements, whatever is hinted at, and its own place.
TEST(PointFinder, GivesSharedPlacesToTheLowestElement) {
  for (const auto& [name, mesh] : cases()) {
    SCOPED_TRACE(name);
    const PointFinder finder(mesh);
    const auto per_element = static_cast<std::size_t>(node_count_of(mesh.kind));
    std::vector<int> lowest(mesh.node_count(), -1);
    for (std::size_t k = mesh.nodes.size(); k-- > 0;)
      lowest[static_cast<std::size_t>(mesh.nodes[k])] = static_cast<int>(k / per_element);
    for (std::size_t n = 0; n < mesh.node_count(); ++n) {
      const Vec<2> x{mesh.x[2 * n], mesh.x[2 * n + 1]};
      for (int hint = -1; hint < static_cast<int>(mesh.element_count()); ++hint) {
        const auto found = finder.find(x, hint);
        ASSERT_TRUE(found);
        ASSERT_EQ(found->element, lowest[n]);
        ASSERT_LE(std::abs(found->s[0]), 1);
        ASSERT_LE(std::abs(found->s[1]), 1);
        ASSERT_LT(distance(place_in(mesh, found->element, found->s), x), 1e-13 * size_of(mesh));
      }
    }
  }
}

/// On edges within rounding, on either side of them, the answer does not depend on the hint.
TEST(PointFinder, AnswersAlikeForAllHintsNearEdges) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(-1, 1);
  for (const auto& [name, mesh] : cases()) {
    SCOPED_TRACE(name);
    const PointFinder finder(mesh);
    const auto count = static_cast<int>(mesh.element_count());
    for (int k = 0; k < 10 * count; ++k) {
      Vec<2> x = place_in(mesh, k % count, {k % 2 ? 1.0 : -1.0, number(random)});
      for (double& xi : x) xi += 1e-14 * size_of(mesh) * number(random) * std::pow(10, 2 * number(random));
      const auto found = finder.find(x);
      if (!found) continue;  // at the rim by more than an element's tolerance
      for (int hint = 0; hint < count; ++hint) {
        const auto again = finder.find(x, hint);
        ASSERT_TRUE(again);
        ASSERT_EQ(again->element, found->element);
        ASSERT_EQ(again->s, found->s);
      }
    }
  }
}

TEST(PointFinder, AgreesWithASearchOfAllElements) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-0.1, 1.1);
  for (const auto& [name, mesh] : cases()) {
    if (mesh.kind != ElementKind::quad4) continue;  // whose edges are straight
    SCOPED_TRACE(name);
    Vec<2> low{mesh.x[0], mesh.x[1]}, high = low;
    for (std::size_t k = 0; k < mesh.x.size(); ++k)
      low[k % 2] = std::min(low[k % 2], mesh.x[k]), high[k % 2] = std::max(high[k % 2], mesh.x[k]);
    const PointFinder finder(mesh);
    int inside = 0, outside = 0;
    for (int k = 0; k < 4000; ++k) {
      const Vec<2> x{low[0] + number(random) * (high[0] - low[0]), low[1] + number(random) * (high[1] - low[1])};
      int element = 0;
      const auto count = static_cast<int>(mesh.element_count());
      while (element < count && !inside_straight(mesh, element, x)) ++element;
      const auto found = finder.find(x);
      ASSERT_EQ(found ? found->element : count, element);
      ++(found ? inside : outside);
    }
    EXPECT_GT(inside, 1000);
    EXPECT_GT(outside, 500);
  }
}

TEST(PointFinder, FindsNothingInAHoleAndOutside) {
  for (const ElementKind kind : {ElementKind::quad4, ElementKind::quad9}) {
    const Mesh mesh = meshed(ring(), kind);
    const PointFinder finder(mesh);
    const double chord = std::cos(std::numbers::pi / 12);  // straight edges come nearer to the centre than the arcs
    for (int k = 0; k < 360; ++k) {
      const double angle = k * std::numbers::pi / 180;
      const auto at = [&](double radius) { return Vec<2>{radius * std::cos(angle), radius * std::sin(angle)}; };
      EXPECT_FALSE(finder.find(at(0.99 * chord * hole)));
      EXPECT_TRUE(finder.find(at(1.01 * hole)));
      EXPECT_TRUE(finder.find(at(0.99 * chord * rim)));
      EXPECT_FALSE(finder.find(at(1.01 * rim)));
    }
    EXPECT_FALSE(finder.find({0, 0}));
    EXPECT_FALSE(finder.find({0, 0}, 3));
    EXPECT_FALSE(finder.find({1e300, -1e300}));
  }
}

TEST(PointFinder, FindsNoPlaceThatIsNotANumber) {
  const Mesh mesh = meshed(ring(), ElementKind::quad9);
  const PointFinder finder(mesh);
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinity, -infinity}) {
    EXPECT_FALSE(finder.find({bad, 1}));
    EXPECT_FALSE(finder.find({1, bad}, 2));
  }
}

TEST(PointFinder, FindsNothingInAMeshOfNoElements) { EXPECT_FALSE(PointFinder(Mesh{}).find({0, 0}, 0)); }

/// A billionth of an element's size outside is on the wall, a millionth is not.
TEST(PointFinder, TakesPlacesALittleOutsideToTheWall) {
  for (const ElementKind kind : {ElementKind::quad4, ElementKind::quad9}) {
    const Mesh mesh = meshed({quadrilateral({{{0, 0}, {3, 1}, {4, 3}, {-1, 2}}}, {3, 2, 1}, {1, 1, 1})}, kind);
    const PointFinder finder(mesh);
    const double size = 1;  // of each element, about
    for (const Vec<2> s : {Vec<2>{0.3, -1}, Vec<2>{-0.8, -1}, Vec<2>{-1, -1}}) {
      const Vec<2> x = place_in(mesh, 0, s), outwards{0.2, -0.97};
      for (const double by : {1e-11, 5e-10}) {
        const auto found = finder.find({x[0] + by * size * outwards[0], x[1] + by * size * outwards[1]});
        ASSERT_TRUE(found);
        EXPECT_EQ(found->element, 0);
        EXPECT_EQ(found->s[1], -1);
        EXPECT_NEAR(found->s[0], s[0], 1e-8);
      }
      EXPECT_FALSE(finder.find({x[0] + 1e-6 * outwards[0], x[1] + 1e-6 * outwards[1]}));
    }
  }
}

}  // namespace
}  // namespace tether
