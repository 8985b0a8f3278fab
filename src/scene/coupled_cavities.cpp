// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <vector>

#include "scene/coupled_checks.hpp"
#include "scene/solids.hpp"

namespace tether {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Which steps from a cell's middle to the next one's go through the boundary of the bodies, and which cells are within
/// them. Middles are moved aside by a little, so that no line meets an edge or a corner.
class Crossings {
 public:
  Crossings(const StaggeredGrid& grid, const Mesh& mesh) : grid_(grid), mesh_(mesh), sides_(boundary_of(mesh)) {
    entered_.assign(grid.face_count(0), 0);
    for (int axis = 0; axis < grid.dim; ++axis) {
      crossed_[at(axis)].assign(grid.face_count(axis), 0);
      for (std::size_t s = 0; s < sides_.size(); s += at(grid.dim)) cross(axis, &sides_[s]);
    }
  }
  /// How often the step across a face goes through the boundary; at the box's sides, the half step from there.
  int crossed(int axis, const std::array<int, 3>& face) const { return crossed_[at(axis)][grid_.face(axis, face)]; }
  /// Of each cell, by how many bodies were entered and not left between it and the box's left side.
  std::vector<bool> within() const {
    std::vector<bool> within(grid_.cell_count());
    int depth = 0;
    for (std::size_t c = 0; c < within.size(); ++c) {
      const auto cell = grid_.place_of_cell(c);
      depth = (cell[0] > 0 ? depth : 0) + entered_[grid_.face(0, cell)];
      within[c] = depth > 0;
    }
    return within;
  }

 private:
  using Line = std::array<double, 2>;
  struct Meeting {
    double place = 0;  ///< along the line
    bool enters = false;
  };

  /// Along the axes other than one, in ascending order: those of the lines of middles across it.
  std::array<int, 2> others(int axis) const { return {axis == 0 ? 1 : 0, axis == 2 ? 1 : 2}; }
  double x(int node, int axis) const { return mesh_.x[at(node * mesh_.dim() + axis)]; }
  double line(int axis, int i) const { return grid_.middle(axis, i) + 3.7e-7 * (axis + 1) * grid_.d[at(axis)]; }

  /// Numbers of the lines that may meet a side along another axis.
  std::array<int, 2> range(int axis, const int* side) const {
    if (axis >= grid_.dim) return {0, 0};
    double low = x(side[0], axis), high = low;
    for (int a = 1; a < grid_.dim; ++a) low = std::min(low, x(side[a], axis)), high = std::max(high, x(side[a], axis));
    const auto number = [&](double place) {
      return static_cast<int>(
          std::clamp((place - grid_.low[at(axis)]) / grid_.d[at(axis)], -1.0, 1.0 * grid_.n[at(axis)]));
    };
    return {std::max(number(low) - 1, 0), std::min(number(high) + 1, grid_.n[at(axis)] - 1)};
  }
  void cross(int axis, const int* side) {
    const auto other = others(axis);
    const auto first = range(other[0], side), second = range(other[1], side);
    std::array<int, 3> face{};
    for (int k = second[0]; k <= second[1]; ++k) {
      for (int j = first[0]; j <= first[1]; ++j) {
        const auto met = meets(axis, side, {line(other[0], j), grid_.dim == 3 ? line(other[1], k) : 0});
        if (!met) continue;
        const double cells =
            (met->place - grid_.low[at(axis)]) / grid_.d[at(axis)] + 0.5;  // from the middle before the box
        face[at(axis)] = static_cast<int>(std::clamp(cells, 0.0, 1.0 * grid_.n[at(axis)]));
        face[at(other[0])] = j, face[at(other[1])] = k;
        ++crossed_[at(axis)][grid_.face(axis, face)];
        if (axis == 0) entered_[grid_.face(0, face)] += met->enters ? 1 : -1;
      }
    }
  }
  /// Where a line along an axis goes through a side; along x also whether into the body, which lies to the left of an
  /// edge, and behind a triangle that turns counter-clockwise.
  std::optional<Meeting> meets(int axis, const int* side, const Line& line) const {
    const auto o = others(axis);
    const auto from = [&](int node, std::size_t i) { return x(node, o[i]) - line[i]; };
    if (grid_.dim == 2) {
      const double a = from(side[0], 0), b = from(side[1], 0);
      if ((a > 0) == (b > 0)) return std::nullopt;
      return Meeting{x(side[0], axis) + a / (a - b) * (x(side[1], axis) - x(side[0], axis)), a > 0};
    }
    std::array<double, 3> part{};  // of each node: the area of the triangle of the line and the other two
    double all = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const int p = side[(i + 1) % 3], q = side[(i + 2) % 3];
      part[i] = from(p, 0) * from(q, 1) - from(p, 1) * from(q, 0);
      all += part[i];
    }
    const bool inside = std::all_of(part.begin(), part.end(), [&](double p) { return p * all > 0; });
    if (!inside) return std::nullopt;
    const double sum = part[0] * x(side[0], axis) + part[1] * x(side[1], axis) + part[2] * x(side[2], axis);
    return Meeting{sum / all, all < 0};
  }

  const StaggeredGrid& grid_;
  const Mesh& mesh_;
  Sides sides_;
  std::array<std::vector<int>, 3> crossed_;  // of each face
  std::vector<int> entered_;                 // bodies entered less left, of each face across x
};

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
      if (!grid.has_cell(next) || marked[grid.cell(next)] || crossings.crossed(axis, face) > 0) continue;
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
  const Crossings crossings(grid, mesh);
  std::vector<bool> marked = crossings.within();
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
