// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/coupled.hpp"

#include <algorithm>
#include <cmath>

namespace tether {

bool AxisBox::contains(const std::array<double, 3>& place) const {
  for (std::size_t i = 0; i < 3; ++i) {
    const double slack = 1e-9 * (high[i] - low[i]);
    if (place[i] < low[i] - slack || place[i] > high[i] + slack) return false;
  }
  return true;
}

AxisBox cells_of(const AxisBox& box, const StaggeredGrid& grid) {
  AxisBox cells = box;
  for (int axis = 0; axis < grid.dim; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    const double slack = 1e-9 * (box.high[i] - box.low[i]) / grid.d[i];  // as contains() has it
    const double first = std::ceil((box.low[i] - grid.low[i]) / grid.d[i] - 0.5 - slack),
                 last = std::floor((box.high[i] - grid.low[i]) / grid.d[i] - 0.5 + slack);
    cells.low[i] = grid.low[i] + std::max(first, 0.0) * grid.d[i];
    cells.high[i] = grid.low[i] + std::min(last + 1, static_cast<double>(grid.n[i])) * grid.d[i];
  }
  return cells;
}

bool has_fluid_beyond(const Coupled& coupled, int side) {
  const BoxSide kind = coupled.sides[static_cast<std::size_t>(side)];
  return kind == BoxSide::open ||
         (kind == BoxSide::wall && std::any_of(coupled.openings.begin(), coupled.openings.end(),
                                               [&](const Opening& opening) { return opening.side == side; }));
}

Systems systems_of(const Coupled& coupled) {
  if (coupled.systems != Systems::automatic) return coupled.systems;
  const bool large = static_cast<double>(coupled.grid.cell_count()) > most_cells_of_factors;
  return coupled.grid.dim == 3 && large ? Systems::krylov : Systems::direct;
}

}  // namespace tether
