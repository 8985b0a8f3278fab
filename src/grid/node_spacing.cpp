// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/node_spacing.hpp"

#include <cmath>

#include "base/index.hpp"

namespace tether {
namespace {

/// An edge of an element from corner to corner.
using Edge = std::array<double, 2>;

std::array<Edge, 4> edges_of(const Mesh& mesh, std::span<const double> x, std::size_t e) {
  std::array<Edge, 4> edges;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto [a, b] = ends_of_edge(mesh, e, k);
    edges[k] = {x[2 * b] - x[2 * a], x[2 * b + 1] - x[2 * a + 1]};
  }
  return edges;
}

double length_of(const Edge& edge) { return std::hypot(edge[0], edge[1]); }

/// How long a quadrilateral is along an edge of another element: by its mean sides a and b, of which the edge is s a +
/// t b, the length over |(s, t)|.
double length_along(const std::array<Edge, 4>& sides, const Edge& edge) {
  const Edge a{0.5 * (sides[0][0] - sides[2][0]), 0.5 * (sides[0][1] - sides[2][1])};
  const Edge b{0.5 * (sides[1][0] - sides[3][0]), 0.5 * (sides[1][1] - sides[3][1])};
  const double area = a[0] * b[1] - a[1] * b[0];
  const double s = (edge[0] * b[1] - edge[1] * b[0]) / area, t = (a[0] * edge[1] - a[1] * edge[0]) / area;
  return length_of(edge) / std::hypot(s, t);
}

std::array<double, 2> middle(const Mesh& mesh, std::span<const double> x, std::size_t e) {
  const int count = node_count_of(mesh.kind);
  std::array<double, 2> sum{};
  for (int a = 0; a < count; ++a) {
    for (std::size_t i = 0; i < 2; ++i) sum[i] += x[2 * at(mesh.element(e)[a]) + i] / count;
  }
  return sum;
}

}  // namespace

std::array<std::size_t, 2> ends_of_edge(const Mesh& mesh, std::size_t e, std::size_t k) {
  const int order = order_of(mesh.kind), row = order * (order + 1);
  const std::array<int, 5> box{0, order, row + order, row, 0}, simplex{0, 1, 2, 0, 1};
  const auto& corners = is_simplex(mesh.kind) ? simplex : box;
  return {at(mesh.element(e)[corners[k]]), at(mesh.element(e)[corners[k + 1]])};
}

std::optional<std::array<NodeSpacing, 4>> NodeSpacings::of_element(const Mesh& body, std::span<const double> x,
                                                                   std::size_t e, int& hint) const {
  const auto found = finder_.find(middle(body, x, e), hint);
  if (!found) return std::nullopt;
  hint = found->element;
  const auto sides = edges_of(below_, below_.x, at(found->element));
  const auto edges = edges_of(body, x, e);
  std::array<NodeSpacing, 4> spacing;
  for (std::size_t k = 0; k < 4; ++k) {
    if (length_of(edges[k]) == 0) continue;
    spacing[k] = {length_of(edges[k]) / order_of(body.kind), length_along(sides, edges[k]) / order_of(below_.kind)};
  }
  return spacing;
}

}  // namespace tether
