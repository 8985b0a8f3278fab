// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "grid/block_mesh.hpp"
#include "grid/mesh_place.hpp"
#include "grid/ways_across.hpp"

namespace tether {
namespace {

template <class Test>
void for_all_shapes(const Test& test) {
  for (const ElementRow& row : element_rows) {
    SCOPED_TRACE(std::string(row.name) + " in " + std::to_string(row.dim) + " dimensions");
    with_shapes(row.kind, [&](auto shapes) { test(row, shapes); });
  }
}

/// A place within any reference element.
template <int dim>
Vec<dim> some_place() {
  Vec<dim> s;
  for (int i = 0; i < dim; ++i) s[at(i)] = 0.13 + 0.11 * i;
  return s;
}

TEST(Shapes, SumToOneAndHaveTheirGradients) {
  for_all_shapes([](const ElementRow&, auto shapes) {
    using S = decltype(shapes);
    const Vec<S::dim> s = some_place<S::dim>();
    const auto N = S::values(s);
    const auto G = S::gradients(s);
    double sum = 0;
    for (const double value : N) sum += value;
    EXPECT_NEAR(sum, 1, 1e-14);
    constexpr double h = 1e-6;
    for (int i = 0; i < S::dim; ++i) {
      Vec<S::dim> up = s, down = s;
      up[at(i)] += h, down[at(i)] -= h;
      for (int a = 0; a < S::nodes; ++a)
        EXPECT_NEAR(G[at(a * S::dim + i)], (S::values(up)[at(a)] - S::values(down)[at(a)]) / (2 * h), 1e-9);
    }
  });
}

TEST(Shapes, AreOneAtTheirOwnNodeAlone) {
  for_all_shapes([](const ElementRow&, auto shapes) {
    using S = decltype(shapes);
    for (int a = 0; a < S::nodes; ++a) {
      const auto N = S::values(S::node_place(a));
      for (int b = 0; b < S::nodes; ++b) EXPECT_NEAR(N[at(b)], a == b ? 1 : 0, 1e-15);
    }
  });
}

/// Integral of s_0^i s_1^j s_2^k over the reference element.
template <class S>
double exact(const std::array<int, 3>& powers) {
  double value = 1;
  if constexpr (S::is_simplex) {
    int sum = S::dim;
    for (int i = 0; i < S::dim; ++i) value *= std::tgamma(powers[at(i)] + 1), sum += powers[at(i)];
    return value / std::tgamma(sum + 1);
  } else {
    for (int i = 0; i < S::dim; ++i) value *= powers[at(i)] % 2 == 1 ? 0 : 2.0 / (powers[at(i)] + 1);
    return value;
  }
}

template <class S, class Place, class Weight>
double by_rule(int points, const std::array<int, 3>& powers, const Place& place, const Weight& weight) {
  double sum = 0;
  for (int k = 0; k < points; ++k) {
    double value = weight(k);
    for (int i = 0; i < S::dim; ++i) value *= std::pow(place(k)[at(i)], powers[at(i)]);
    sum += value;
  }
  return sum;
}

/// Rules are exact to their orders, and those of masses have positive weights.
TEST(Shapes, RulesAreExact) {
  for_all_shapes([](const ElementRow& row, auto shapes) {
    using S = decltype(shapes);
    for (int k = 0; k < S::mass_points; ++k) EXPECT_GT(S::mass_weight(k), 0);
    for (int i = 0; i <= 2 * row.order; ++i) {
      for (int j = 0; i + j <= 2 * row.order; ++j) {
        for (int k = 0; i + j + k <= (row.dim == 3 ? 2 * row.order : i + j); ++k) {
          const std::array powers{i, j, k};
          const double right = exact<S>(powers);
          EXPECT_NEAR(by_rule<S>(S::mass_points, powers, S::mass_place, S::mass_weight), right, 1e-14);
          if (i + j + k > 2) continue;
          EXPECT_NEAR(by_rule<S>(S::points, powers, S::place, S::weight), right, 1e-14);
        }
      }
    }
  });
}

Mesh block_of(ElementKind kind) {
  Block block;
  block.edges = {straight({0, 0}, {2, 0}), straight({2, 0}, {2, 1}), straight({2, 1}, {0, 1}),
                 straight({0, 1}, {0, 0})};
  block.cells = {2, 2, 2}, block.z_high = 1;
  std::vector<MeshFlaw> flaws;
  return mesh_of_blocks({block}, kind, flaws);
}

/// By its corners alone a straight mesh has the same volume, and its boundary the same elements.
TEST(Mesh, ByItsCornersIsOfOrder1) {
  for (const ElementRow& row : element_rows) {
    SCOPED_TRACE(row.name);
    const Mesh mesh = block_of(row.kind), linear = by_corners(mesh);
    EXPECT_EQ(order_of(linear.kind), 1);
    EXPECT_EQ(is_simplex(linear.kind), row.simplex);
    ASSERT_EQ(linear.element_count(), mesh.element_count());
    double volume = 0;
    for (std::size_t e = 0; e < linear.element_count(); ++e) volume += volume_of_element(linear, e);
    EXPECT_NEAR(volume, 2, 1e-12);
    EXPECT_EQ(elements_of_sides(linear, boundary_of(linear)), elements_of_sides(mesh, boundary_of(mesh)));
  }
}

/// Each side of the boundary belongs to the element that has its nodes; one between elements to none.
TEST(Mesh, SidesBelongToTheirElements) {
  for (const ElementRow& row : element_rows) {
    SCOPED_TRACE(row.name);
    const Mesh mesh = block_of(row.kind);
    const Sides boundary = boundary_of(mesh);
    const auto elements = elements_of_sides(mesh, boundary);
    for (std::size_t k = 0; k < boundary.size(); ++k) {
      const std::size_t e = elements[k / static_cast<std::size_t>(row.side_nodes)];
      ASSERT_LT(e, mesh.element_count());
      EXPECT_NE(std::find(mesh.element(e), mesh.element(e) + row.nodes, boundary[k]), mesh.element(e) + row.nodes);
    }
    Sides of_first;
    add_sides(row.kind, mesh.element(0), of_first);
    const auto found = elements_of_sides(mesh, of_first);
    EXPECT_NE(std::find(found.begin(), found.end(), mesh.element_count()), found.end());
  }
}

TEST(Mesh, PlacesLieInTheirElements) {
  for (const ElementRow& row : element_rows) {
    SCOPED_TRACE(row.name);
    const Mesh mesh = block_of(row.kind);
    int holders = 0;
    for (std::size_t e = 0; e < mesh.element_count(); ++e) {
      holders += is_in_element(mesh, e, {0.3, 0.11, 0.2}) ? 1 : 0;
      EXPECT_FALSE(is_in_element(mesh, e, {2.001, 0.5, 0.5}));
    }
    EXPECT_EQ(holders, 1);
  }
}

}  // namespace
}  // namespace tether
