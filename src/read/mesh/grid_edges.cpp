// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/mesh/grid_edges.hpp"

#include <cmath>

namespace tether {

std::array<GridEdge, 4> edges_of(const Scene& scene) {
  const BackgroundGrid& grid = scene.grid;
  const double width = grid.x1 - grid.x0, height = grid.y1 - grid.y0;
  return {{{"wl", 0, grid.x0, width, scene.walls.left},
           {"wr", 0, grid.x1, width, scene.walls.right},
           {"wb", 1, grid.y0, height, scene.walls.bottom},
           {"wt", 1, grid.y1, height, scene.walls.top}}};
}

std::vector<int> nodes_at(const Mesh& mesh, const GridEdge& edge) {
  const auto dim = static_cast<std::size_t>(mesh.dim());
  std::vector<int> nodes;
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    if (std::abs(mesh.x[n * dim + edge.axis] - edge.place) <= 1e-9 * edge.size) nodes.push_back(static_cast<int>(n));
  }
  return nodes;
}

}  // namespace tether
