// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/overlaps.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "grid/crossings.hpp"
#include "unit/physics/box/bodies_support.hpp"

namespace tether {
namespace {

using coupled::support::all;
using coupled::support::hollow_block;
using coupled::support::lattice;
using coupled::support::together;
using coupled::support::turned_block;

Mesh block(int dim, int n, const Vec<3>& middle, double side, double angle = 0) {
  return lattice(dim, {n, n, n}, all, turned_block(middle, {side, side, dim == 3 ? side : 0}, angle));
}

std::size_t nodes_inside(const Mesh& mesh) { return OverlapFinder(mesh).find(mesh.x).nodes; }

/// By solid angles, to all sides.
std::size_t by_winding(const Mesh& mesh) {
  const SolidSurface surface = surface_of(mesh);
  const std::vector<int> parts = parts_of(mesh);
  std::size_t count = 0;
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    const Vec<3> x = place_of(mesh.x, static_cast<int>(n), mesh.dim());
    count += std::abs(turns_about(surface, mesh.x, x, parts[n])) > 0.5 ? 1 : 0;
  }
  return count;
}

TEST(OverlapFinder, AreThoseThatWindingsFind) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1, 1);
  for (const int dim : {2, 3}) {
    std::size_t total = 0;
    for (int k = 0; k < 20; ++k) {
      const Vec<3> away{0.8 * number(random), 0.8 * number(random), dim == 3 ? 0.8 * number(random) : 0};
      const Mesh mesh = together(block(dim, 3, {}, 1, number(random)), block(dim, 4, away, 0.7, number(random)));
      EXPECT_EQ(nodes_inside(mesh), by_winding(mesh)) << dim << " " << k;
      total += by_winding(mesh);
    }
    EXPECT_GT(total, 50u);
  }
}

/// Nodes above nodes, sides on one line, a cavity that a body stands in, boxes that meet where the bodies do not.
TEST(OverlapFinder, BodiesThatTouchOrEncloseOthersDoNot) {
  for (const int dim : {2, 3}) {
    EXPECT_EQ(nodes_inside(together(block(dim, 3, {}, 1), block(dim, 3, {1, 0, 0}, 1))), 0u);
    EXPECT_EQ(nodes_inside(together(block(dim, 3, {}, 1), block(dim, 2, {0.4, 1, 0}, 1))), 0u);
    EXPECT_EQ(nodes_inside(together(hollow_block(dim, 1, {}, 3, 0), block(dim, 3, {}, 1))), 0u);
    EXPECT_EQ(nodes_inside(together(hollow_block(dim, 1, {}, 3, 0.3), block(dim, 3, {}, 0.8, 0.3))), 0u);
    EXPECT_EQ(nodes_inside(together(block(dim, 3, {}, 1), block(dim, 3, {0.99999999, 0, 0}, 1))), 0u);
    EXPECT_GT(nodes_inside(together(block(dim, 3, {}, 1), block(dim, 3, {0.99, 0.1, dim == 3 ? 0.1 : 0}, 1))), 0u);
  }
}

/// On the same lattice, where lines to the side run along edges and through nodes.
TEST(OverlapFinder, CountAlignedNodes) {
  EXPECT_EQ(nodes_inside(together(block(2, 4, {}, 1), block(2, 4, {0.25, 0.25, 0}, 1))), 18u);
  EXPECT_EQ(nodes_inside(together(block(3, 4, {}, 1), block(3, 4, {0.25, 0.25, 0.25}, 1))), 54u);
  const Overlap found = OverlapFinder(together(block(2, 4, {}, 1), block(2, 4, {0.5, 0.5, 0}, 1)))
                            .find(together(block(2, 4, {}, 1), block(2, 4, {0.5, 0.5, 0}, 1)).x);
  EXPECT_EQ(found.nodes, 8u);
  EXPECT_NE(found.part, found.other);
}

/// Quadrilaterals and hexahedra of order 1 and 2: a cube's corner in another one.
TEST(OverlapFinder, OfAllElements) {
  for (const ElementKind kind : {ElementKind::quad4, ElementKind::quad9, ElementKind::hex8, ElementKind::hex27}) {
    const int p = order_of(kind), dim = dimension_of(kind);
    Mesh one;
    one.kind = kind;
    one.region = {0};
    for (int k = 0; k <= (dim == 3 ? p : 0); ++k) {
      for (int j = 0; j <= p; ++j) {
        for (int i = 0; i <= p; ++i) {
          one.nodes.push_back(static_cast<int>(one.nodes.size()));
          one.x.insert(one.x.end(), {double(i) / p, double(j) / p});
          if (dim == 3) one.x.push_back(double(k) / p);
        }
      }
    }
    Mesh other = one;
    for (double& x : other.x) x += 0.6;
    EXPECT_EQ(nodes_inside(together(one, other)), 2u) << static_cast<int>(kind);
    for (double& x : other.x) x += 0.4;
    EXPECT_EQ(nodes_inside(together(one, other)), 0u) << static_cast<int>(kind);
  }
}

/// Two bars across each other, of one element each: no node lies in the other, and yet their sides cross. Bodies that
/// touch, lie in each other's boxes or stand in a cavity have no such sides.
TEST(OverlapFinder, SidesThatCrossWithoutANodeInside) {
  for (const int dim : {2, 3}) {
    const double deep = dim == 3 ? 0.2 : 0;
    const Mesh bars =
        together(lattice(dim, {1, 1, 1}, all, turned_block({0, 0.01, 0}, {2, 0.1, deep}, 0)),
                 lattice(dim, {1, 1, 1}, all, turned_block({0.09, 0, 0.013 * (dim - 2)}, {0.08, 2, deep}, 0)));
    EXPECT_EQ(nodes_inside(bars), 0u);
    const CrossedSides crossed = OverlapFinder(bars).find_crossed(bars.x);
    EXPECT_EQ(crossed.part, 0) << dim;
    EXPECT_EQ(crossed.other, 1);
    EXPECT_LE(std::abs(crossed.place[0] - 0.09), 0.05);
    for (const Mesh& apart : {together(block(dim, 3, {}, 1), block(dim, 3, {1, 0, 0}, 1)),
                              together(block(dim, 3, {}, 1), block(dim, 2, {0.4, 1, 0}, 1)),
                              together(block(dim, 1, {}, 1), block(dim, 1, {0.99999999, 0.3, 0}, 1)),
                              together(block(dim, 2, {}, 1, 0.7), block(dim, 2, {0.95, 0.9, 0}, 1, 0.7)),
                              together(hollow_block(dim, 1, {}, 3, 0.3), block(dim, 3, {}, 1, 0.3))})
      EXPECT_EQ(OverlapFinder(apart).find_crossed(apart.x).part, -1) << dim;
  }
}

/// A strip that is rolled up through itself; one that is open has no such node, notch or not.
TEST(OverlapFinder, OfABodyWithItself) {
  const auto rolled = [](double turn) {
    return lattice(2, {40, 2, 1}, all, [turn](const Vec<3>& s) {
      const double angle = turn * s[0], radius = 1 - 0.2 * s[1];
      return Vec<3>{-radius * std::cos(angle), radius * std::sin(angle), 0};
    });
  };
  EXPECT_EQ(nodes_inside(rolled(5.9)), 0u);
  EXPECT_EQ(nodes_inside(rolled(3.0)), 0u);
  const auto keep = [](const coupled::support::Cell& c) { return c[0] < 2 || c[1] != 1; };
  EXPECT_EQ(nodes_inside(lattice(2, {4, 3, 1}, keep, turned_block({}, {1, 1, 0}, 0.4))), 0u);
  const auto notch = [&](const Vec<3>& s) {
    return Vec<3>{s[0], s[1] + (s[0] > 0.6 && s[1] > 0.3 && s[1] < 0.6 ? 0.2 : 0), 0};
  };
  EXPECT_EQ(nodes_inside(lattice(2, {4, 3, 1}, keep, notch)), 0u);
  const auto closed = [&](const Vec<3>& s) {
    return Vec<3>{s[0], s[1] + (s[0] > 0.6 && s[1] > 0.3 && s[1] < 0.4 ? 0.5 : 0), 0};
  };
  EXPECT_GT(nodes_inside(lattice(2, {4, 3, 1}, keep, closed)), 0u);
}

}  // namespace
}  // namespace tether
