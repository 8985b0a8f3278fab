// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "grid/kernels.hpp"
#include "loops/nodes.hpp"
#include "loops/points.hpp"
#include "physics/points/derived.hpp"
#include "physics/points/state.hpp"

namespace tether::mpm {

// Which nodes and cells points reach.

/// Marks what a kernel reaches around a cell.
template <class Kernel>
void mark(ActiveNodes& active, const Locator& locator, double x, double y) {
  const auto at = Kernel::locate(locator, x, y);
  active.mark(at.i + Kernel::first, at.i + Kernel::last, at.j + Kernel::first, at.j + Kernel::last);
}

template <class Kernel>
void list_active(State& state) {
  const Points& P = state.points;
  const Locator locator(state.grid.frame.shape);
  ActiveNodes& active = state.grid.active;
  active.begin();
  for (std::size_t b = 0; b < state.ranges.size(); ++b) {
    if (!state.blocks[b]) {
      for_points(P, state.ranges[b], [&](std::size_t p) { mark<Kernel>(active, locator, P.x[p], P.y[p]); });
      continue;
    }
    const int last = static_cast<int>(Blocks::lanes) - 1 + Kernel::last;
    for (const Blocks::Group& at : state.blocks[b]->groups())
      active.mark(at.cell + Kernel::first, at.cell + last, at.row + Kernel::first, at.row + Kernel::last);
  }
  active.end();
  state.grid.list_ghosts();
}

/// Counts the cells that points of the scene are in: of a row, those abreast.
template <class Kernel>
std::size_t count_cells(const State& state, const Scene& scene) {
  const Points& P = state.points;
  const Unfolding unfolding(scene.strip.get());
  const Order order = unfolded(order_of_all(state), unfolding);
  const Locator locator(state.grid.frame.shape);
  std::vector<bool> holds(state.grid.frame.shape.nodes());
  for (std::size_t k = 0; k < order.slots.size(); ++k) {
    const Vec<2> place = unfolding.place(k, {P.x[order.slots[k]], P.y[order.slots[k]]});
    const auto at = Kernel::locate(locator, place[0], place[1]);
    holds[static_cast<std::size_t>(at.j) * static_cast<std::size_t>(state.grid.frame.shape.nx) +
          static_cast<std::size_t>(at.i)] = true;
  }
  return static_cast<std::size_t>(std::count(holds.begin(), holds.end(), true));
}

}  // namespace tether::mpm
