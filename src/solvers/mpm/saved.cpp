// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "solvers/mpm/state.hpp"

namespace tether::mpm {
namespace {

/// Sums at the nodes that hold points, in the order of the list of these nodes.
struct ActiveSums {
  std::vector<double> m, momentum_x, momentum_y, force_x, force_y;
};

ActiveSums active_sums(const Grid& grid) {
  ActiveSums active;
  for (const int node : grid.active_nodes) {
    const NodeSums& sum = grid.sums[static_cast<std::size_t>(node)];
    active.m.push_back(sum.m);
    active.momentum_x.push_back(sum.momentum[0]);
    active.momentum_y.push_back(sum.momentum[1]);
    active.force_x.push_back(sum.force[0]);
    active.force_y.push_back(sum.force[1]);
  }
  return active;
}

void put_sums(const ActiveSums& active, Grid& grid) {
  for (std::size_t k = 0; k < grid.active_nodes.size(); ++k) {
    NodeSums& sum = grid.sums[static_cast<std::size_t>(grid.active_nodes[k])];
    sum.m = active.m[k];
    sum.momentum = pair(active.momentum_x[k], active.momentum_y[k]);
    sum.force = pair(active.force_x[k], active.force_y[k]);
  }
}

/// The list of what a state consists of, once for both ways.
template <class Exchange, class AnyState, class Sums>
void exchange(Exchange& with, AnyState& state, Sums& sums) {
  auto& P = state.points;
  with("x", P.x), with("y", P.y), with("vx", P.vx), with("vy", P.vy);
  with("mass", P.mass), with("volume", P.volume);
  with("sxx", P.sxx), with("syy", P.syy), with("sxy", P.sxy);
  with("rho", P.rho), with("energy", P.energy), with("strain", P.strain);
  with("tx", P.tx), with("ty", P.ty), with("id", P.id);
  with.list("active_cells", state.grid.active_cells), with.list("active_nodes", state.grid.active_nodes);
  with.list("node_mass", sums.m);
  with.list("node_momentum_x", sums.momentum_x), with.list("node_momentum_y", sums.momentum_y);
  with.list("node_force_x", sums.force_x), with.list("node_force_y", sums.force_y);
  with("time", state.time), with("time_lost", state.time_lost);
  with("c_max", state.c_max), with("wave_max", state.wave_max);
  with("steps", state.steps), with("dt_last", state.dt_last), with("dt_min", state.dt_min);
  with("crossings_since_sort", state.crossings_since_sort), with("limit_told", state.limit_told);
}

}  // namespace

SavedState save(const State& state) {
  StateSaver saver;
  const ActiveSums sums = active_sums(state.grid);
  exchange(saver, state, sums);
  return saver.take();
}

void restore(State& state, const SavedState& saved) {
  std::fill(state.grid.sums.begin(), state.grid.sums.end(), NodeSums{});
  StateRestorer restorer(saved);
  ActiveSums sums;
  exchange(restorer, state, sums);
  put_sums(sums, state.grid);
}

}  // namespace tether::mpm
