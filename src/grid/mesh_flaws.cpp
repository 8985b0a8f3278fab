// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/mesh_flaws.hpp"

#include "grid/mesh_extent.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "base/vec.hpp"
#include "grid/shapes.hpp"

namespace tether {
namespace {

/// Smallest Jacobian of an element over its points of quadrature and its corners.
template <class Shapes>
double smallest_jacobian(const Mesh& mesh, std::size_t e) {
  double smallest = std::numeric_limits<double>::infinity();
  for (int point = 0; point < Shapes::points; ++point) {
    smallest = std::min(smallest, jacobian_at<Shapes>(mesh, e, Shapes::place(point)).determinant);
  }
  for (int corner = 0; corner < Shapes::corners; ++corner)
    smallest = std::min(smallest, jacobian_at<Shapes>(mesh, e, Shapes::corner(corner)).determinant);
  return smallest;
}

double coordinate(const Mesh& mesh, int node, std::size_t i) {
  return mesh.x[static_cast<std::size_t>(node) * static_cast<std::size_t>(mesh.dim()) + i];
}

/// Corners of a side in its own order of nodes.
std::vector<int> corners_of(ElementKind kind, const int* side) {
  const int count = side_node_count_of(kind), p = order_of(kind);
  if (dimension_of(kind) == 2) return {side[0], side[count - 1]};
  if (is_simplex(kind)) return {side[0], side[1], side[2]};
  const std::ptrdiff_t line = p + 1;
  return {side[0], side[p], side[line * line - 1], side[line * p]};
}

/// Returns whether a node lies within a side, to 1e-6 of its size: in the plane of its corners and on the inner side of
/// each of its edges, not at a corner.
bool lies_within(const Mesh& mesh, const std::vector<int>& corners, int node) {
  using V = Vec<3>;
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

std::string place_text(const Vec<3>& x, int dim) {
  return dim == 2 ? fmt::format("({:.6g}, {:.6g})", x[0], x[1])
                  : fmt::format("({:.6g}, {:.6g}, {:.6g})", x[0], x[1], x[2]);
}

std::string place_text(const Mesh& mesh, int node) {
  const auto dim = static_cast<std::size_t>(mesh.dim());
  const double* at = &mesh.x[static_cast<std::size_t>(node) * dim];
  return place_text({at[0], at[1], dim == 3 ? at[2] : 0}, mesh.dim());
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

namespace {

constexpr double cell_size = 4;  // of the lattice that nodes are sorted into, in tolerances

/// A cell of the lattice that a node touches, and the node.
struct Touch {
  std::array<long long, 3> cell{};
  int node = 0;
  bool operator<(const Touch& other) const { return cell != other.cell ? cell < other.cell : node < other.node; }
};

/// The node's cell and those that it comes near to from below: of two nodes in one place both touch the one that the
/// higher coordinates of each direction are in. The lattice lies a part of a cell off the lowest corner, so that nodes
/// of regular meshes touch one cell alone.
void add_touches(const Mesh& mesh, int node, const MeshExtent& extent, std::vector<Touch>& touches) {
  const auto dim = static_cast<std::size_t>(mesh.dim());
  const double within = coincident * extent.size(), cell = cell_size * within;
  std::array<std::array<long long, 2>, 3> range{};
  for (std::size_t i = 0; i < dim; ++i) {
    const double x = mesh.x[static_cast<std::size_t>(node) * dim + i] - extent.low[i] + 0.4 * cell;
    range[i] = {std::llround(std::floor(x / cell)), std::llround(std::floor((x + within) / cell))};
  }
  for (long long k = range[2][0]; k <= range[2][1]; ++k) {
    for (long long j = range[1][0]; j <= range[1][1]; ++j) {
      for (long long i = range[0][0]; i <= range[0][1]; ++i) touches.push_back({{i, j, k}, node});
    }
  }
}

bool coincide(const Mesh& mesh, int a, int b, double within) {
  const auto dim = static_cast<std::size_t>(mesh.dim());
  for (std::size_t i = 0; i < dim; ++i) {
    const double difference =
        mesh.x[static_cast<std::size_t>(a) * dim + i] - mesh.x[static_cast<std::size_t>(b) * dim + i];
    if (std::abs(difference) > within) return false;
  }
  return true;
}

}  // namespace

std::vector<std::pair<int, int>> coinciding_nodes(const Mesh& mesh) {
  const MeshExtent extent(mesh);
  std::vector<std::pair<int, int>> pairs;
  const auto count = static_cast<int>(mesh.node_count());
  if (extent.size() == 0) {
    for (int n = 1; n < count; ++n) pairs.emplace_back(0, n);
    return pairs;
  }
  std::vector<Touch> touches;
  for (int n = 0; n < count; ++n) add_touches(mesh, n, extent, touches);
  std::sort(touches.begin(), touches.end());
  for (std::size_t first = 0, k = 0; k < touches.size(); ++k) {
    if (touches[k].cell != touches[first].cell) first = k;
    const auto other = std::find_if(
        touches.begin() + static_cast<std::ptrdiff_t>(first), touches.begin() + static_cast<std::ptrdiff_t>(k),
        [&](const Touch& touch) { return coincide(mesh, touch.node, touches[k].node, coincident * extent.size()); });
    if (other != touches.begin() + static_cast<std::ptrdiff_t>(k)) pairs.emplace_back(other->node, touches[k].node);
  }
  const auto by_node = [](const auto& a, const auto& b) {
    return std::pair(a.second, a.first) < std::pair(b.second, b.first);
  };
  std::sort(pairs.begin(), pairs.end(), by_node);
  pairs.erase(
      std::unique(pairs.begin(), pairs.end(), [](const auto& a, const auto& b) { return a.second == b.second; }),
      pairs.end());
  return pairs;
}

}  // namespace tether
