// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "grid/mesh_flaws.hpp"

namespace tether {
namespace {

constexpr double tolerance = 1e-9;  // of the mesh's size
constexpr double cell_size = 4;     // of the lattice that nodes are sorted into, in tolerances

/// A cell of the lattice that a node touches, and the node.
struct Touch {
  std::array<long long, 3> cell{};
  int node = 0;
  bool operator<(const Touch& other) const { return cell != other.cell ? cell < other.cell : node < other.node; }
};

/// Lowest corner and largest extent of a mesh.
struct Extent {
  std::array<double, 3> low{};
  double size = 0;
};

Extent extent_of(const Mesh& mesh) {
  const auto dim = static_cast<std::size_t>(mesh.dim());
  Extent extent;
  for (std::size_t i = 0; i < dim && !mesh.x.empty(); ++i) {
    double low = mesh.x[i], high = mesh.x[i];
    for (std::size_t n = i; n < mesh.x.size(); n += dim)
      low = std::min(low, mesh.x[n]), high = std::max(high, mesh.x[n]);
    extent.low[i] = low, extent.size = std::max(extent.size, high - low);
  }
  return extent;
}

/// The node's cell and those that it comes near to from below: of two nodes in one place both touch the one that the
/// higher coordinates of each direction are in. The lattice lies a part of a cell off the lowest corner, so that nodes
/// of regular meshes touch one cell alone.
void add_touches(const Mesh& mesh, int node, const Extent& extent, std::vector<Touch>& touches) {
  const auto dim = static_cast<std::size_t>(mesh.dim());
  const double within = tolerance * extent.size, cell = cell_size * within;
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
  const Extent extent = extent_of(mesh);
  std::vector<std::pair<int, int>> pairs;
  const auto count = static_cast<int>(mesh.node_count());
  if (extent.size == 0) {
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
        [&](const Touch& touch) { return coincide(mesh, touch.node, touches[k].node, tolerance * extent.size); });
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
