// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/liquid/parts.hpp"

#include <algorithm>
#include <cmath>

namespace tether::liquid {
namespace {

/// Of the distance at a cell, by the cells on both sides, or the one that there is [1/cell].
double slope_at(const StaggeredGrid& grid, std::span<const double> distance, std::size_t cell, int axis) {
  const int i = grid.place_of_cell(cell)[at(axis)], n = grid.n[at(axis)];
  const std::size_t low = i == 0 ? cell : cell - grid.stride(axis), high = i == n - 1 ? cell : cell + grid.stride(axis);
  return low == high ? 0 : (distance[high] - distance[low]) / ((i == 0 || i == n - 1) ? 1 : 2);
}

}  // namespace

/// What a surface leaves of a box is linear in its distance from the box's middle while it meets all lines along the
/// steepest axis: taken for all of it, over the width that the box has across the surface.
coupled::CellParts liquid_parts(const StaggeredGrid& grid, std::span<const double> distance) {
  const std::size_t count = std::size_t{1} << at(grid.dim);
  coupled::CellParts parts(distance.size() * count);
  for (std::size_t c = 0; c < distance.size(); ++c) {
    Vec<3> slope{};
    double width = 0;
    for (int a = 0; a < grid.dim; ++a) {
      slope[at(a)] = slope_at(grid, distance, c, a);
      width += std::abs(slope[at(a)]);
    }
    width = 0.5 * std::max(width, 1.0);
    for (std::size_t k = 0; k < count; ++k) {
      double there = distance[c];
      for (std::size_t a = 0; a < at(grid.dim); ++a) there += ((k >> a & 1) != 0 ? 0.25 : -0.25) * slope[a];
      parts[count * c + k] = std::clamp(0.5 - there / width, 0.0, 1.0);
    }
  }
  return parts;
}

}  // namespace tether::liquid
