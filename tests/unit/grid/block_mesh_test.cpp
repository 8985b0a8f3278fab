// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/block_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "grid/mesh.hpp"
#include "grid/shapes.hpp"
#include "unit/grid/mesh_support.hpp"

namespace tether {
namespace {

Block quadrilateral(const std::array<Vec<2>, 4>& corners, std::array<int, 3> cells) {
  Block block;
  for (std::size_t k = 0; k < 4; ++k) block.edges[k] = straight(corners[k], corners[(k + 1) % 4]);
  block.cells = cells;
  block.z_low = 0, block.z_high = 2;
  return block;
}

Block rectangle(Vec<2> low, Vec<2> high, std::array<int, 3> cells) {
  return quadrilateral({low, {high[0], low[1]}, high, {low[0], high[1]}}, cells);
}

constexpr std::array all_kinds{ElementKind::quad4, ElementKind::quad9, ElementKind::tri3, ElementKind::tri6,
                               ElementKind::hex8,  ElementKind::hex27, ElementKind::tet4, ElementKind::tet10};

TEST(BlockMesh, FillsASkewBlockWithoutAFlaw) {
  const Block block = quadrilateral({{{0, 0}, {3, 1}, {4, 3}, {-1, 2}}}, {3, 4, 2});
  const double area = 0.5 * (4 * 1 + 3 * 4);  // half the cross product of its diagonals (4, 3) and (-4, 1)
  for (const ElementKind kind : all_kinds) {
    std::vector<MeshFlaw> flaws;
    const Mesh mesh = mesh_of_blocks({block}, kind, flaws);
    EXPECT_TRUE(flaws.empty());
    EXPECT_NEAR(volume(mesh), area * (mesh.dim() == 3 ? 2 : 1), 1e-12);
  }
}

/// A field that is linear in space is met by the shape functions, with its gradient.
TEST(BlockMesh, ElementsMeetLinearFields) {
  const Block block = quadrilateral({{{0, 0}, {3, 1}, {4, 3}, {-1, 2}}}, {2, 2, 2});
  for (const ElementKind kind : all_kinds) {
    std::vector<MeshFlaw> flaws;
    const Mesh mesh = mesh_of_blocks({block}, kind, flaws);
    const auto dim = static_cast<std::size_t>(mesh.dim());
    with_shapes(kind, [&](auto shapes) {
      using Shapes = decltype(shapes);
      for (std::size_t e = 0; e < mesh.element_count(); ++e) {
        for (int k = 0; k < Shapes::points; ++k) {
          const auto map = jacobian_at<Shapes>(mesh, e, Shapes::place(k));
          std::array<double, 3> gradient{};
          for (int a = 0; a < Shapes::nodes; ++a) {
            const double* x = &mesh.x[static_cast<std::size_t>(mesh.element(e)[a]) * dim];
            const double value = 2 * x[0] - 3 * x[1] + (dim == 3 ? 5 * x[2] : 0);
            for (std::size_t i = 0; i < dim; ++i)
              gradient[i] += value * map.gradients[static_cast<std::size_t>(a) * dim + i];
          }
          EXPECT_NEAR(gradient[0], 2, 1e-11);
          EXPECT_NEAR(gradient[1], -3, 1e-11);
          if (dim == 3) {
            EXPECT_NEAR(gradient[2], 5, 1e-11);
          }
        }
      }
    });
  }
}

TEST(BlockMesh, JoinsBlocksAtSharedEdges) {
  for (const ElementKind kind : all_kinds) {
    std::vector<MeshFlaw> flaws;
    const Mesh mesh =
        mesh_of_blocks({rectangle({0, 0}, {1, 1}, {2, 2, 1}), rectangle({1, 0}, {2, 1}, {3, 2, 1})}, kind, flaws);
    EXPECT_TRUE(flaws.empty());
    const int p = order_of(kind), lines = mesh.dim() == 3 ? p + 1 : 1;
    EXPECT_EQ(mesh.node_count(), static_cast<std::size_t>((5 * p + 1) * (2 * p + 1) * lines));
    const auto parts = parts_of(mesh);
    EXPECT_EQ(*std::max_element(parts.begin(), parts.end()), 0);
  }
}

/// Whichever of its vertices a block begins with, tetrahedra of neighbours meet in the same triangles.
TEST(BlockMesh, TetrahedraOfTurnedBlocksMeet) {
  const std::array<std::array<double, 2>, 4> corners{{{1, 0}, {3, 0}, {3, 1}, {1, 1}}};
  for (std::size_t turn = 0; turn < 4; ++turn) {
    std::array<std::array<double, 2>, 4> turned = corners;
    std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(turn), turned.end());
    for (const ElementKind kind : {ElementKind::tet4, ElementKind::tet10}) {
      std::vector<MeshFlaw> flaws;
      const Mesh mesh =
          mesh_of_blocks({rectangle({0, 0}, {1, 1}, {2, 2, 3}), quadrilateral(turned, {2, 2, 3})}, kind, flaws);
      EXPECT_TRUE(flaws.empty());
      EXPECT_NEAR(volume(mesh), 6, 1e-12);
      const auto per_side = static_cast<std::size_t>(side_node_count_of(kind));
      EXPECT_EQ(boundary_of(mesh).size(), 2u * per_side * (2 * 8 + 2 * 12 + 2 * 3 * 2)) << turn;  // of 2 x 4 x 3 boxes
    }
  }
}

TEST(BlockMesh, TellsOfBlocksThatTouchWithoutBeingJoined) {
  for (const ElementKind kind : {ElementKind::quad4, ElementKind::quad9, ElementKind::tri6, ElementKind::hex8,
                                 ElementKind::tet4, ElementKind::tet10}) {
    std::vector<MeshFlaw> flaws;
    mesh_of_blocks({rectangle({0, 0}, {1, 1}, {2, 2, 1}), rectangle({1, 0}, {2, 1}, {2, 3, 1})}, kind, flaws);
    ASSERT_EQ(flaws.size(), 1u);
    EXPECT_NE(flaws[0].message.find("hangs"), std::string::npos);
  }
}

TEST(BlockMesh, TellsOfElementsTurnedInsideOut) {
  for (const ElementKind kind : all_kinds) {
    std::vector<MeshFlaw> flaws;
    mesh_of_blocks({quadrilateral({{{0, 0}, {0, 1}, {1, 1}, {1, 0}}}, {1, 1, 1})}, kind, flaws);  // clockwise
    ASSERT_EQ(flaws.size(), 1u);
    EXPECT_NE(flaws[0].message.find("inside out"), std::string::npos);
  }
}

/// With an angle of more than 180 degrees a quadrilateral is turned inside out at that corner alone.
TEST(BlockMesh, TellsOfConcaveElements) {
  for (const ElementKind kind : {ElementKind::quad4, ElementKind::quad9, ElementKind::hex8}) {
    std::vector<MeshFlaw> flaws;
    mesh_of_blocks({quadrilateral({{{0, 0}, {1, 0}, {0.4, 0.4}, {0, 1}}}, {1, 1, 1})}, kind, flaws);
    EXPECT_EQ(flaws.size(), 1u);
  }
}

TEST(BlockMesh, CurvedEdgesBringTheArea) {
  constexpr double pi = std::numbers::pi;
  std::array<double, 2> error{};
  for (std::size_t k = 0; k < 2; ++k) {
    const int n = k == 0 ? 4 : 8;
    Block ring;  // a quarter ring between radii 1 and 2
    ring.edges = {straight({1, 0}, {2, 0}), elliptic({2, 0}, {0, 2}, {0, 0}, 2, 2), straight({0, 2}, {0, 1}),
                  elliptic({0, 1}, {1, 0}, {0, 0}, 1, 1)};
    ring.cells = {2, n, 1};
    std::vector<MeshFlaw> flaws;
    error[k] = std::abs(volume(mesh_of_blocks({ring}, ElementKind::quad9, flaws)) / (0.75 * pi) - 1);
    EXPECT_TRUE(flaws.empty());
  }
  EXPECT_LT(error[0], 1e-4);
  EXPECT_NEAR(std::log2(error[0] / error[1]), 4, 0.3);
}

TEST(BlockMesh, GradingIsTheRatioOfTheLastCellToTheFirst) {
  Block block = rectangle({0, 0}, {1, 1}, {5, 1, 1});
  block.grading = {4, 1, 1};
  std::vector<MeshFlaw> flaws;
  const Mesh mesh = mesh_of_blocks({block}, ElementKind::quad4, flaws);
  const auto x = [&](std::size_t k) { return mesh.x[2 * k]; };
  EXPECT_NEAR((x(5) - x(4)) / (x(1) - x(0)), 4, 1e-12);
  EXPECT_NEAR((x(3) - x(2)) / (x(2) - x(1)), (x(2) - x(1)) / (x(1) - x(0)), 1e-12);
  EXPECT_DOUBLE_EQ(x(5), 1);
}

/// Of odd and even numbers of cells, finest at both ends and in the middle: 1 2 4 8 4 2 1, 1 2 4 4 2 1, 9 3 1 3 9.
TEST(BlockMesh, GradingOfTheMiddleIsSymmetricAndGeometric) {
  const std::vector<std::pair<double, std::vector<double>>> lines{
      {8, {1, 2, 4, 8, 4, 2, 1}}, {4, {1, 2, 4, 4, 2, 1}}, {1.0 / 9, {9, 3, 1, 3, 9}}, {5, {1, 1}}, {5, {1}}};
  for (const auto& [middle, sizes] : lines) {
    const double whole = std::accumulate(sizes.begin(), sizes.end(), 0.0);
    for (const ElementKind kind : {ElementKind::quad4, ElementKind::quad9}) {
      Block block = rectangle({0, 0}, {whole, 1}, {static_cast<int>(sizes.size()), 1, 1});
      block.grading_middle = {middle, 1, 1};
      std::vector<MeshFlaw> flaws;
      const Mesh mesh = mesh_of_blocks({block}, kind, flaws);
      const auto p = static_cast<std::size_t>(order_of(kind));
      const auto x = [&](std::size_t k) { return mesh.x[2 * k]; };
      for (std::size_t k = 0; k < sizes.size(); ++k) {
        EXPECT_NEAR(x(p * (k + 1)) - x(p * k), sizes[k], 1e-13 * whole) << middle << " " << k;
        if (p == 2) {
          EXPECT_NEAR(x(2 * k + 1), 0.5 * (x(2 * k) + x(2 * k + 2)), 1e-14 * whole);
        }
      }
    }
  }
}

/// The second block goes the other way along the edge that they share.
TEST(BlockMesh, NeighboursOfOneGradingOfTheMiddleAreJoined) {
  Block left = rectangle({0, 0}, {1, 3}, {2, 9, 1});
  Block right = quadrilateral({{{2, 3}, {1, 3}, {1, 0}, {2, 0}}}, {3, 9, 1});
  left.grading_middle[1] = right.grading_middle[1] = 1e3;
  for (const ElementKind kind : {ElementKind::quad4, ElementKind::quad9}) {
    const auto p = static_cast<std::size_t>(order_of(kind));
    std::vector<MeshFlaw> flaws;
    EXPECT_EQ(mesh_of_blocks({left, right}, kind, flaws).node_count(), (5 * p + 1) * (9 * p + 1));
    EXPECT_TRUE(flaws.empty());
    Block other = right;
    other.grading_middle[1] = 1e3 * 1.01;
    mesh_of_blocks({left, other}, kind, flaws);
    EXPECT_FALSE(flaws.empty());
  }
}

TEST(BlockMesh, SidesHaveNamesAndTheirWholeArea) {
  Block block = rectangle({0, 0}, {1, 3}, {2, 2, 2});
  block.names[1] = "tip";
  for (const ElementKind kind : {ElementKind::hex8, ElementKind::hex27, ElementKind::tet4}) {
    std::vector<MeshFlaw> flaws;
    const Mesh mesh = mesh_of_blocks({block}, kind, flaws);
    const auto per_side = static_cast<std::size_t>(side_node_count_of(kind));
    const std::size_t triangles = kind == ElementKind::tet4 ? 2 : 1;
    for (const char* name : {"1.bottom", "1.right", "1.top", "1.left", "1.back", "1.front", "tip"}) {
      ASSERT_EQ(mesh.sides.count(name), 1u) << name;
      EXPECT_EQ(mesh.sides.at(name).size(), 4 * triangles * per_side) << name;
    }
    EXPECT_EQ(mesh.sides.at("tip"), mesh.sides.at("1.right"));
    EXPECT_EQ(boundary_of(mesh).size(), 24 * triangles * per_side);
    for (const int node : mesh.sides.at("1.front")) EXPECT_DOUBLE_EQ(mesh.x[static_cast<std::size_t>(node) * 3 + 2], 2);
  }
}

/// A side between two blocks that both name is loaded once.
TEST(BlockMesh, ASideOfTwoBlocksStandsOnceUnderItsName) {
  Block left = rectangle({0, 0}, {1, 1}, {2, 2, 2}), right = rectangle({1, 0}, {2, 1}, {2, 2, 2});
  left.names[1] = right.names[3] = "joint";
  for (const ElementKind kind : {ElementKind::quad4, ElementKind::hex8}) {
    std::vector<MeshFlaw> flaws;
    const Mesh mesh = mesh_of_blocks({left, right}, kind, flaws);
    EXPECT_TRUE(flaws.empty());
    EXPECT_EQ(mesh.sides.at("joint").size(), mesh.sides.at("1.left").size());
  }
}

TEST(BlockMesh, BlocksHangTogetherByWholeSides) {
  const Block first = rectangle({0, 0}, {1, 1}, {2, 2, 2}), beside = rectangle({1, 0}, {2, 1}, {2, 2, 2}),
              hinged = rectangle({2, 1}, {3, 2}, {2, 2, 2});
  for (const ElementKind kind : {ElementKind::quad4, ElementKind::quad9, ElementKind::tri3, ElementKind::tet4}) {
    std::vector<MeshFlaw> flaws;
    const Mesh mesh = mesh_of_blocks({first, beside, hinged}, kind, flaws);
    EXPECT_EQ(count_parts(mesh), 1);
    const std::vector<int> block = blocks_by_sides(mesh);
    for (std::size_t e = 0; e < block.size(); ++e) EXPECT_EQ(block[e], mesh.region[e] == 2 ? 1 : 0);
  }
}

}  // namespace
}  // namespace tether
