// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/mesh_flaws.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "grid/jacobian.hpp"

namespace tether {
namespace {

/// Smallest Jacobian of an element over its points of quadrature, and the corners of quadrilaterals and hexahedra.
template <class Shapes>
double smallest_jacobian(const Mesh& mesh, std::size_t e) {
  double smallest = std::numeric_limits<double>::infinity();
  for (int point = 0; point < Shapes::points; ++point) {
    smallest = std::min(smallest, jacobian_at<Shapes>(mesh, e, Shapes::place(point)).determinant);
  }
  if (is_simplex(mesh.kind)) return smallest;  // it is the same everywhere
  for (int corner = 0; corner < 1 << Shapes::dim; ++corner) {
    std::array<double, Shapes::dim> s;
    for (int i = 0; i < Shapes::dim; ++i) s[static_cast<std::size_t>(i)] = (corner >> i & 1) == 1 ? 1 : -1;
    smallest = std::min(smallest, jacobian_at<Shapes>(mesh, e, s).determinant);
  }
  return smallest;
}

double coordinate(const Mesh& mesh, int node, std::size_t i) {
  return mesh.x[static_cast<std::size_t>(node) * static_cast<std::size_t>(mesh.dim()) + i];
}

/// Corners of a side in its own order of nodes.
std::vector<int> corners_of(ElementKind kind, const int* side) {
  const int count = side_node_count_of(kind), p = order_of(kind);
  if (dimension_of(kind) == 2) return {side[0], side[count - 1]};
  if (kind == ElementKind::tet4) return {side[0], side[1], side[2]};
  const std::ptrdiff_t line = p + 1;
  return {side[0], side[p], side[line * line - 1], side[line * p]};
}

/// Whether a node lies within a side, to 1e-6 of its size: in the plane of its corners and on the inner side of each of
/// its edges, not at a corner.
bool lies_within(const Mesh& mesh, const std::vector<int>& corners, int node) {
  using V = std::array<double, 3>;
  const auto dim = static_cast<std::size_t>(mesh.dim());
  const auto at = [&](int n) {
    V v{};
    for (std::size_t i = 0; i < dim; ++i) v[i] = coordinate(mesh, n, i);
    return v;
  };
  const auto minus = [](const V& a, const V& b) { return V{a[0] - b[0], a[1] - b[1], a[2] - b[2]}; };
  const auto dot = [](const V& a, const V& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  const auto cross = [](const V& a, const V& b) {
    return V{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  const V p = at(node), a = at(corners[0]), along = minus(at(corners[1]), a), to = minus(p, a);
  const double length = std::sqrt(dot(along, along)), within = 1e-6;
  if (dim == 2) {
    const double s = dot(to, along) / (length * length), off = std::abs(along[0] * to[1] - along[1] * to[0]) / length;
    return s > within && s < 1 - within && off < within * length;
  }
  const V normal = cross(along, minus(at(corners.back()), a));
  const double size = std::sqrt(dot(normal, normal));
  if (std::abs(dot(normal, to)) > within * size * length) return false;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const V from = at(corners[k]), edge = minus(at(corners[(k + 1) % corners.size()]), from), there = minus(p, from);
    const double inside = dot(cross(edge, there), normal) / (size * size);
    if (inside < -within) return false;
    if (dot(there, there) < within * within * length * length) return false;
  }
  return true;
}

/// The region of the first element that has all these nodes.
int region_with(const Mesh& mesh, const std::vector<int>& nodes) {
  const auto per_element = static_cast<std::ptrdiff_t>(node_count_of(mesh.kind));
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const int* first = mesh.element(e);
    const bool all = std::all_of(nodes.begin(), nodes.end(), [&](int node) {
      return std::find(first, first + per_element, node) != first + per_element;
    });
    if (all) return mesh.region[e];
  }
  return 0;
}

}  // namespace

std::string place_text(const Mesh& mesh, int node) {
  const auto dim = static_cast<std::size_t>(mesh.dim());
  const double* at = &mesh.x[static_cast<std::size_t>(node) * dim];
  return dim == 2 ? fmt::format("({:.6g}, {:.6g})", at[0], at[1])
                  : fmt::format("({:.6g}, {:.6g}, {:.6g})", at[0], at[1], at[2]);
}

std::vector<std::size_t> inverted_elements(const Mesh& mesh) {
  std::vector<std::size_t> inverted;
  with_shapes(mesh.kind, [&](auto shapes) {
    using Shapes = decltype(shapes);
    for (std::size_t e = 0; e < mesh.element_count(); ++e) {
      if (!(smallest_jacobian<Shapes>(mesh, e) > 0)) inverted.push_back(e);
    }
  });
  return inverted;
}

void find_inverted(const Mesh& mesh, std::vector<MeshFlaw>& flaws) {
  std::set<int> told;
  for (const std::size_t e : inverted_elements(mesh)) {
    if (!told.insert(mesh.region[e]).second) continue;
    flaws.push_back(
        {static_cast<std::size_t>(mesh.region[e]),
         fmt::format("element {} at {} is turned inside out or flat", e + 1, place_text(mesh, mesh.element(e)[0])),
         "corners go counter-clockwise, and no corner's angle is 180 degrees or more"});
  }
}

std::optional<HangingNode> hanging_node(const Mesh& mesh) {
  const Sides boundary = boundary_of(mesh);
  const auto per_side = static_cast<std::size_t>(side_node_count_of(mesh.kind));
  std::vector<int> nodes(boundary);
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  std::sort(nodes.begin(), nodes.end(), [&](int a, int b) { return coordinate(mesh, a, 0) < coordinate(mesh, b, 0); });
  for (std::size_t s = 0; s < boundary.size(); s += per_side) {
    const std::vector<int> side(boundary.begin() + static_cast<std::ptrdiff_t>(s),
                                boundary.begin() + static_cast<std::ptrdiff_t>(s + per_side));
    const auto corners = corners_of(mesh.kind, side.data());
    const auto [low, high] = std::minmax_element(
        corners.begin(), corners.end(), [&](int a, int b) { return coordinate(mesh, a, 0) < coordinate(mesh, b, 0); });
    const double slack = 1e-6 * (coordinate(mesh, *high, 0) - coordinate(mesh, *low, 0)) + 1e-12;
    auto node = std::lower_bound(nodes.begin(), nodes.end(), coordinate(mesh, *low, 0) - slack,
                                 [&](int n, double x) { return coordinate(mesh, n, 0) < x; });
    for (; node != nodes.end() && coordinate(mesh, *node, 0) <= coordinate(mesh, *high, 0) + slack; ++node) {
      if (std::find(side.begin(), side.end(), *node) != side.end() || !lies_within(mesh, corners, *node)) continue;
      return HangingNode{*node, region_with(mesh, {*node}), region_with(mesh, side)};
    }
  }
  return std::nullopt;
}

void find_hanging(const Mesh& mesh, const std::vector<int>& numbers, std::vector<MeshFlaw>& flaws) {
  const auto hanging = hanging_node(mesh);
  if (!hanging) return;
  flaws.push_back(
      {static_cast<std::size_t>(hanging->region),
       fmt::format("the node at {} hangs: it lies within a side of region {} that does not have it",
                   place_text(mesh, hanging->node), numbers[static_cast<std::size_t>(hanging->region_of_side)]),
       "blocks are joined where whole edges with equally many cells and the same grading coincide"});
}

}  // namespace tether
