// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "grid/mesh.hpp"
#include "model/scene.hpp"

namespace tether {

/// An edge of the grid, x or y (axis 0, 1) = place, what the deck calls its wall, and the grid's size across it
/// [length].
struct GridEdge {
  const char* variable;
  std::size_t axis;
  double place, size;
  Wall wall;
};
std::array<GridEdge, 4> edges_of(const Scene& scene);
/// Nodes of a mesh that stand at an edge, as near as rounding tells.
std::vector<int> nodes_at(const Mesh& mesh, const GridEdge& edge);

}  // namespace tether
