// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "results/saved_state.hpp"
#include "scene/scene.hpp"
#include "solvers/mpm/arrays.hpp"
#include "solvers/mpm/density.hpp"
#include "solvers/mpm/range.hpp"

namespace tether::mpm {

/// All that changes while a scene runs.
struct State {
  Points points;
  Grid grid;
  std::vector<Range> ranges;           // slots of each body
  std::vector<Range> gas;              // slots of the gas bodies
  std::vector<Range> gas_by_cells;     // of those that take their density from cells
  std::optional<CellDensity> density;  // where the gas takes its density from cells
  double time = 0, time_lost = 0;      // sum of the steps, and what rounding took from it [time]
  double c_max = 0;                    // largest sound speed of the gas after the last step [velocity]
  double wave_max = 0;                 // its largest c + |v| [velocity]
  long long steps = 0;
  double dt_last = 0, dt_min = 0;      // [time]
  long long crossings_since_sort = 0;  // of points, from cell to cell
  bool limit_told = false;             // whether a shorter step than the deck's was told
};

/// The state at time 0: densities, stresses and tangents from what the scene says, and the first map to the grid (step
/// 1 of the algorithm), so that every step begins with its sums in place.
State start(const Scene& scene);

/// The state as plain data, and back into a state of the same scene, to the last bit: sums at nodes are kept as they
/// are, since points that were sorted meanwhile would add up to others. Scratch arrays are left out. restore() throws
/// FileError.
SavedState save(const State& state);
void restore(State& state, const SavedState& saved);

}  // namespace tether::mpm
