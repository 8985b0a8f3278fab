// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/mesh_place.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/numbers.hpp"
#include "grid/shapes.hpp"

namespace tether {
namespace {

constexpr double rounding = 1e-9;    // of an element's size, within which a place is that of a node
constexpr int most_iterations = 40;  // of Newton's method for a place in the reference element

template <class Shapes>
using Point = std::array<double, static_cast<std::size_t>(Shapes::dim)>;

template <class Shapes>
double length(const Point<Shapes>& v) {
  double square = 0;
  for (const double component : v) square += component * component;
  return std::sqrt(square);
}

/// The place of the reference element that stands for s where s is outside of it.
template <class Shapes>
Point<Shapes> inside(Point<Shapes> s) {
  if constexpr (Shapes::is_simplex) {
    double sum = 0;
    for (double& component : s) sum += component = std::max(component, 0.0);
    for (double& component : s) component /= std::max(sum, 1.0);
  } else {
    for (double& component : s) component = std::clamp(component, -1.0, 1.0);
  }
  return s;
}

/// Returns what separates x from the place that s stands for.
template <class Shapes>
Point<Shapes> remainder(const Mesh& mesh, std::size_t e, const Vec<3>& x, const Point<Shapes>& s) {
  const auto N = Shapes::values(s);
  Point<Shapes> r{};
  for (std::size_t a = 0; a < N.size(); ++a) {
    const double* node = &mesh.x[static_cast<std::size_t>(mesh.element(e)[a]) * r.size()];
    for (std::size_t i = 0; i < r.size(); ++i) r[i] += N[a] * (x[i] - node[i]);
  }
  return r;
}

/// ds = (dx/ds)^-1 r.
template <class Shapes>
Point<Shapes> correction(const Mesh& mesh, std::size_t e, const Point<Shapes>& s, const Point<Shapes>& r) {
  constexpr std::size_t dim = Shapes::dim;
  const auto G = Shapes::gradients(s);
  std::array<double, dim * dim> J{};
  for (std::size_t a = 0; a < static_cast<std::size_t>(Shapes::nodes); ++a) {
    const double* node = &mesh.x[static_cast<std::size_t>(mesh.element(e)[a]) * dim];
    for (std::size_t i = 0; i < dim; ++i) {
      for (std::size_t j = 0; j < dim; ++j) J[i * dim + j] += node[i] * G[a * dim + j];
    }
  }
  invert(J);
  Point<Shapes> ds{};
  for (std::size_t i = 0; i < dim; ++i) {
    for (std::size_t j = 0; j < dim; ++j) ds[i] += J[i * dim + j] * r[j];
  }
  return ds;
}

/// The place in the reference element by Newton's method from its middle, kept within it or not far from it.
template <class Shapes>
Point<Shapes> reference_place(const Mesh& mesh, std::size_t e, const Vec<3>& x) {
  Point<Shapes> s{};
  if constexpr (Shapes::is_simplex) s.fill(1.0 / (Shapes::dim + 1));
  for (int k = 0; k < most_iterations; ++k) {
    const Point<Shapes> ds = correction<Shapes>(mesh, e, s, remainder<Shapes>(mesh, e, x, s));
    if (!std::isfinite(length<Shapes>(ds))) break;
    for (std::size_t i = 0; i < s.size(); ++i) s[i] += ds[i];
    if (length<Shapes>(ds) < 1e-14) break;
    if constexpr (!Shapes::is_simplex) {
      for (double& component : s) component = std::clamp(component, -2.0, 2.0);
    }
  }
  return inside<Shapes>(s);
}

/// A box around an element's nodes; edges of higher order may leave it by a part of its size.
template <class Shapes>
struct BoxOfNodes {
  Point<Shapes> low, high;
  double size = 0;

  BoxOfNodes(const Mesh& mesh, std::size_t e) {
    low.fill(std::numeric_limits<double>::infinity()), high.fill(-std::numeric_limits<double>::infinity());
    for (int a = 0; a < Shapes::nodes; ++a) {
      const double* node = &mesh.x[static_cast<std::size_t>(mesh.element(e)[a]) * low.size()];
      for (std::size_t i = 0; i < low.size(); ++i)
        low[i] = std::min(low[i], node[i]), high[i] = std::max(high[i], node[i]);
    }
    for (std::size_t i = 0; i < low.size(); ++i) size = std::max(size, high[i] - low[i]);
  }
  /// No place of the element is nearer to x.
  double away(const Vec<3>& x) const {
    Point<Shapes> r{};
    for (std::size_t i = 0; i < r.size(); ++i) r[i] = std::max({low[i] - x[i], x[i] - high[i], 0.0});
    return std::max(length<Shapes>(r) - 0.5 * size, 0.0);
  }
};

template <class Shapes>
MeshPlace place_at(const Mesh& mesh, std::size_t e, const Point<Shapes>& s) {
  const auto N = Shapes::values(s);
  MeshPlace place;
  for (std::size_t a = 0; a < N.size(); ++a) {
    if (std::abs(N[a] - 1) < rounding) return {{mesh.element(e)[a]}, {1}};
    place.nodes.push_back(mesh.element(e)[a]), place.parts.push_back(N[a]);
  }
  return place;
}

template <class Shapes>
NearestPlace nearest_of(const Mesh& mesh, const Vec<3>& x) {
  NearestPlace best{{}, 0, std::numeric_limits<double>::infinity(), 0};
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const BoxOfNodes<Shapes> box(mesh, e);
    if (box.away(x) >= best.away) continue;
    const Point<Shapes> s = reference_place<Shapes>(mesh, e, x);
    const double away = length<Shapes>(remainder<Shapes>(mesh, e, x, s));
    if (away < best.away) best = {place_at<Shapes>(mesh, e, s), e, away, box.size};
    if (best.away <= rounding * box.size) break;
  }
  return best;
}

}  // namespace

double MeshPlace::of(std::span<const double> values, std::size_t per_node, std::size_t i) const {
  double sum = 0;
  for (std::size_t a = 0; a < nodes.size(); ++a)
    sum += parts[a] * values[static_cast<std::size_t>(nodes[a]) * per_node + i];
  return sum;
}

NearestPlace nearest_place(const Mesh& mesh, const Vec<3>& x) {
  return with_shapes(mesh.kind, [&](auto shapes) { return nearest_of<decltype(shapes)>(mesh, x); });
}

bool is_in_element(const Mesh& mesh, std::size_t e, const Vec<3>& x) {
  return with_shapes(mesh.kind, [&](auto shapes) {
    using Shapes = decltype(shapes);
    const Point<Shapes> s = reference_place<Shapes>(mesh, e, x);
    return length<Shapes>(remainder<Shapes>(mesh, e, x, s)) <= rounding * BoxOfNodes<Shapes>(mesh, e).size;
  });
}

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

Vec<2> middle(const Mesh& mesh, std::span<const double> x, std::size_t e) {
  const int count = node_count_of(mesh.kind);
  Vec<2> sum{};
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
