// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <vector>

#include "base/index.hpp"
#include "grid/crossings.hpp"
#include "model/solids.hpp"
#include "read/box/checks.hpp"

namespace tether {
namespace {

/// Marks a cell that is not marked and all that steps from it lead to.
void fill(const StaggeredGrid& grid, const Crossings& crossings, std::size_t first, std::vector<bool>& marked) {
  if (marked[first]) return;
  std::vector<std::size_t> front{first};
  marked[first] = true;
  while (!front.empty()) {
    const auto cell = grid.place_of_cell(front.back());
    front.pop_back();
    for (int side = 0; side < 2 * grid.dim; ++side) {
      const int axis = axis_of_side(side);
      auto next = cell, face = cell;
      next[at(axis)] += is_low_side(side) ? -1 : 1;
      if (!is_low_side(side)) ++face[at(axis)];
      if (!grid.has_cell(next) || marked[grid.cell(next)] || crossings.lowest[at(axis)][grid.face(axis, face)] >= 0)
        continue;
      marked[grid.cell(next)] = true;
      front.push_back(grid.cell(next));
    }
  }
}

bool at_a_side(const StaggeredGrid& grid, const std::array<int, 3>& cell) {
  for (int axis = 0; axis < grid.dim; ++axis) {
    if (cell[at(axis)] == 0 || cell[at(axis)] == grid.n[at(axis)] - 1) return true;
  }
  return false;
}

}  // namespace

bool encloses_cells(const Coupled& coupled, const Mesh& mesh) {
  const StaggeredGrid& grid = coupled.grid;
  const Crossings crossings = find_crossings(surface_of(mesh), mesh.x, grid);
  std::vector<bool> marked(crossings.inside.begin(), crossings.inside.end());
  for (std::size_t c = 0; c < marked.size(); ++c) {
    const auto cell = grid.place_of_cell(c);
    const std::array middle{grid.middle(0, cell[0]), grid.middle(1, cell[1]), grid.middle(2, cell[2])};
    const auto holds = [&](const AxisBox& box) { return box.contains(middle); };
    if (std::any_of(coupled.obstacles.begin(), coupled.obstacles.end(), holds) ||
        std::any_of(coupled.voids.begin(), coupled.voids.end(), holds))
      marked[c] = true;
  }
  for (std::size_t c = 0; c < marked.size(); ++c) {
    if (at_a_side(grid, grid.place_of_cell(c))) fill(grid, crossings, c, marked);
  }
  return std::find(marked.begin(), marked.end(), false) != marked.end();
}

}  // namespace tether
