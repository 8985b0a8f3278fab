// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/thickness.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace tether {
namespace {

/// A bar of `cells` elements, 1 thick along y, sheared along x and turned by an angle about z.
struct Bar {
  std::array<int, 3> cells;
  double length, width = 1, angle = 0, shear = 0;
};

int number(const Bar& bar, int i, int j, int k) { return i + (bar.cells[0] + 1) * (j + (bar.cells[1] + 1) * k); }

void add_nodes(const Bar& bar, int dim, Mesh& mesh) {
  for (int k = 0; k <= (dim == 3 ? bar.cells[2] : 0); ++k) {
    for (int j = 0; j <= bar.cells[1]; ++j) {
      for (int i = 0; i <= bar.cells[0]; ++i) {
        const double y = 1.0 * j / bar.cells[1], x = bar.length * i / bar.cells[0] + bar.shear * y,
                     c = std::cos(bar.angle), s = std::sin(bar.angle);
        mesh.x.insert(mesh.x.end(), {c * x - s * y, s * x + c * y});
        if (dim == 3) mesh.x.push_back(bar.width * k / bar.cells[2]);
      }
    }
  }
}

/// Triangles by a diagonal of each cell, tetrahedra six a cell around its diagonal.
void add_cell(const std::array<int, 8>& n, Mesh& mesh) {
  const auto add = [&](std::initializer_list<int> corners) {
    for (const int corner : corners) mesh.nodes.push_back(n[static_cast<std::size_t>(corner)]);
    mesh.region.push_back(0);
  };
  if (mesh.kind == ElementKind::quad4) return add({0, 1, 2, 3});
  if (mesh.kind == ElementKind::hex8) return add({0, 1, 2, 3, 4, 5, 6, 7});
  if (mesh.kind == ElementKind::tri3) return add({0, 1, 3}), add({0, 3, 2});
  add({0, 1, 3, 7}), add({0, 3, 2, 7}), add({0, 2, 6, 7}), add({0, 6, 4, 7}), add({0, 4, 5, 7}), add({0, 5, 1, 7});
}

Mesh mesh_of(const Bar& bar, ElementKind kind) {
  Mesh mesh;
  mesh.kind = kind;
  add_nodes(bar, mesh.dim(), mesh);
  for (int k = 0; k < (mesh.dim() == 3 ? bar.cells[2] : 1); ++k) {
    for (int j = 0; j < bar.cells[1]; ++j) {
      for (int i = 0; i < bar.cells[0]; ++i) {
        std::array<int, 8> n{};
        for (int a = 0; a < 8; ++a) n[static_cast<std::size_t>(a)] = number(bar, i + a % 2, j + a / 2 % 2, k + a / 4);
        add_cell(n, mesh);
      }
    }
  }
  return mesh;
}

constexpr std::array kinds{ElementKind::quad4, ElementKind::tri3, ElementKind::hex8, ElementKind::tet4};

TEST(ElementsAcross, CountsTheLayersOfABarWhicheverWayItLies) {
  for (const ElementKind kind : kinds) {
    for (const double angle : {0.0, 0.4, 1.5}) {
      const auto found = elements_across(mesh_of({{12, 3, 4}, 6, 2, angle}, kind));
      ASSERT_EQ(found.size(), 1u);
      EXPECT_EQ(found[0].count, 3) << static_cast<int>(kind) << " " << angle;
      EXPECT_NEAR(found[0].thickness, 1, 1e-12);
      EXPECT_NEAR(found[0].along, 0.5, 1e-12);
      EXPECT_EQ(found[0].regions, std::vector<int>{0});
    }
  }
}

/// Slanted ends, by up to 63 degrees, make it no thinner and leave no layer out: it bends as its length does.
TEST(ElementsAcross, TakesTheThicknessOfShearedBodiesAtRightAngles) {
  for (const ElementKind kind : kinds) {
    for (const double shear : {-2.0, -0.6, 0.17, 0.6, 1.0, 2.0}) {
      const auto found = elements_across(mesh_of({{30, 3, 10}, 10, 3, 0.4, shear}, kind));
      EXPECT_EQ(found.at(0).count, 3) << static_cast<int>(kind) << " " << shear;
      EXPECT_NEAR(found.at(0).thickness, 1, 1e-9) << static_cast<int>(kind) << " " << shear;
      EXPECT_NEAR(found.at(0).along, 1.0 / 3, 0.02) << static_cast<int>(kind) << " " << shear;
    }
  }
}

/// Short ones, of which a straight way from a slanted end soon comes out again.
TEST(ElementsAcross, TakesTheThicknessOfShearedBlocks) {
  for (const ElementKind kind : {ElementKind::quad4, ElementKind::tri3}) {
    for (const double shear : {-0.5, -0.17, 0.17, 0.5}) {
      const auto found = elements_across(mesh_of({{8, 6, 1}, 1.35, 1, 1.57, shear}, kind));
      EXPECT_EQ(found.at(0).count, 6) << static_cast<int>(kind) << " " << shear;
      EXPECT_NEAR(found.at(0).thickness, 1, 1e-9) << static_cast<int>(kind) << " " << shear;
    }
  }
}

/// As mesh files have them: nodes inside are off their places by up to a third of an element.
TEST(ElementsAcross, CountsTheLayersOfIrregularElements) {
  for (const ElementKind kind : kinds) {
    const Bar bar{{24, 3, 6}, 8, 2};
    Mesh mesh = mesh_of(bar, kind);
    const auto dim = static_cast<std::size_t>(mesh.dim());
    const std::array<double, 3> size{8, 1, 2};
    for (std::size_t n = 0; n < mesh.node_count(); ++n) {
      double* x = &mesh.x[n * dim];
      for (std::size_t i = 0; i < dim; ++i) {
        const bool inside = x[i] > 1e-9 && x[i] < size[i] - 1e-9;
        if (inside) x[i] += 0.1 * std::sin(static_cast<double>(7 * n + 3 * i));
      }
    }
    const auto found = elements_across(mesh);
    EXPECT_EQ(found.at(0).count, 3) << static_cast<int>(kind);
    EXPECT_NEAR(found.at(0).thickness, 1, 0.05);
  }
}

TEST(ElementsAcross, TakesTheThinDirectionWhateverTheElementsAre) {
  for (const ElementKind kind : kinds) {
    const auto found = elements_across(mesh_of({{2, 5, 2}, 0.25, 4}, kind));
    EXPECT_EQ(found.at(0).count, 2) << static_cast<int>(kind);
    EXPECT_NEAR(found.at(0).thickness, 0.25, 1e-12);
  }
}

TEST(ElementsAcross, OfEachBodyByItself) {
  Mesh mesh = mesh_of({{12, 3, 1}, 6}, ElementKind::quad4);
  const Mesh other = mesh_of({{5, 2, 1}, 9}, ElementKind::quad4);
  const int first = static_cast<int>(mesh.node_count());
  for (std::size_t k = 0; k < other.x.size(); ++k) mesh.x.push_back(other.x[k] + (k % 2 == 0 ? 20 : 0));
  for (const int node : other.nodes) mesh.nodes.push_back(first + node);
  mesh.region.insert(mesh.region.end(), other.element_count(), 1);
  const auto found = elements_across(mesh);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].count, 3);
  EXPECT_EQ(found[1].count, 2);
  EXPECT_EQ(found[1].regions, std::vector<int>{1});
  EXPECT_NEAR(found[1].longest, 9, 1e-12);
}

}  // namespace
}  // namespace tether
