// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/liquid/settle.hpp"

#include <algorithm>

#include "base/numbers.hpp"

namespace tether::liquid {
namespace {

/// Returns whether no cell about a cell, corners included, has air.
bool within_liquid(const StaggeredGrid& grid, std::span<const double> distance, std::size_t cell) {
  const auto place = grid.place_of_cell(cell);
  const int deep = grid.dim == 3 ? 1 : 0;
  for (int k = -deep; k <= deep; ++k) {
    for (int j = -1; j <= 1; ++j) {
      for (int i = -1; i <= 1; ++i) {
        const std::array next{place[0] + i, place[1] + j, place[2] + k};
        if (grid.has_cell(next) && distance[grid.cell(next)] >= 0) return false;
      }
    }
  }
  return true;
}

}  // namespace

std::vector<double> crowding(const StaggeredGrid& grid, std::span<const double> distance, std::span<const double> open,
                             const coupled::PressureNumbers& numbers, std::span<const double> filled) {
  constexpr double least_open = 0.3;  // of a hat: with less nothing is known
  constexpr double most = 0.5, gain = 0.25;
  std::vector<double> out(numbers.cell.size(), 0.0);
  for (std::size_t p = 0; p < out.size(); ++p) {
    const std::size_t c = numbers.cell[p];
    if (distance[c] >= 0 || open[c] < least_open) continue;
    double excess = filled[c] / open[c] - 1;
    if (!within_liquid(grid, distance, c)) excess = std::max(excess, 0.0);
    out[p] = gain * std::clamp(excess, -most, most) * grid.volume();
  }
  return out;
}

}  // namespace tether::liquid
