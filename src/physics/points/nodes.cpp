// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/points/nodes.hpp"

#include "physics/points/balance.hpp"

namespace tether::mpm {

void solve_momentum(StepWork& work, double dt) {
  Grid& grid = work.state.grid;
  const Pair gravity = pair(0, work.scene.gravity);
  for (const int node : grid.active_nodes) {
    const auto n = static_cast<std::size_t>(node);
    const NodeSums sum = grid.sums[n];
    const double per_m = inverse(sum.m);
    NodeMotion motion;
    motion.a = sum.force * per_m + gravity;
    motion.u = sum.momentum * per_m + dt * motion.a;
    hold(grid.frame.held[n], motion.a);
    hold(grid.frame.held[n], motion.u);
    grid.motion[n] = motion;
  }
  grid.unfold_motion();
}

void total_nodes(StepWork& work, double dt) {
  const State& state = work.state;
  const Grid& grid = state.grid;
  const Contact& contact = state.contact;
  work.nodes.light = state.light_node;
  for (const int node : grid.active_nodes) {
    const auto n = static_cast<std::size_t>(node);
    if (contact.on() && contact.slot(n) >= 0) continue;  // where each body has its own
    work.nodes.add(grid.sums[n], grid.motion[n], grid.frame.held[n], dt);
  }
  work.nodes.light = 0;  // impulses have work of their own
  if (contact.on()) contact.total(work.nodes, grid.frame, dt);
}

void divide_convected(Grid& grid) {
  for (const int node : grid.active_nodes) {
    const auto n = static_cast<std::size_t>(node);
    Pair v = inverse(grid.sums.m[n]) * Pair(grid.convected[n]);
    hold(grid.frame.held[n], v);
    grid.convected[n] = v;
  }
  grid.unfold_convected();
}

void mapped_velocity(Grid& grid) {
  for (const int node : grid.active_nodes) {
    const auto n = static_cast<std::size_t>(node);
    grid.convected[n] = grid.sums.momentum[n];
  }
  divide_convected(grid);
}

void clear_convected(Grid& grid) {
  for (const int node : grid.active_nodes) grid.convected[static_cast<std::size_t>(node)] = Pair{};
  for (const Ghost& ghost : grid.frame.ghosts) grid.convected[static_cast<std::size_t>(ghost.node)] = Pair{};
}

void clear_sums(Grid& grid) {
  for (const int node : grid.active_nodes) grid.sums[static_cast<std::size_t>(node)] = NodeSums{};
}

void map_anew(State& state, const Scene& scene, const StepSet& set) {
  Grid& grid = state.grid;
  const std::vector<int> before = grid.active_nodes;
  set.list_active(grid, state.points);
  for (const int node : before) {
    const auto n = static_cast<std::size_t>(node);
    if (grid.loss.empty() || grid.loss[n] == 0 || grid.node_stamp[n] == grid.stamp) continue;
    state.heat_under_way -= grid.loss[n];
    state.strips.book_lost_heat(grid.loss[n]);
    grid.loss[n] = 0;
  }
  set.map_all(state, scene, grid.sums);
}

void forget_sums(State& state, const StepSet& set) {
  clear_sums(state.grid);
  set.list_active(state.grid, state.points);
  clear_sums(state.grid);
}

void clear_forces(Grid& grid) {
  for (const int node : grid.active_nodes) grid.sums.force[static_cast<std::size_t>(node)] = Pair{};
}

void gas_at_nodes(Grid& grid) {
  for (const int node : grid.active_nodes) {
    const auto n = static_cast<std::size_t>(node);
    const double gas = grid.sums.gas[n];
    grid.gas.rho[n] = gas * grid.frame.per_volume[n];
    if (!grid.loss.empty()) grid.gas.heat[n] = grid.loss[n] * inverse(gas);
  }
  grid.unfold_gas();
}

void give_to_all_gas(State& state, double energy) {
  state.heat_under_way += energy;
  state.heat_for_all += energy;
  state.heat_given += energy;
}

void clear_heat(State& state) {
  Grid& grid = state.grid;
  for (const int node : grid.active_nodes) grid.loss[static_cast<std::size_t>(node)] = 0;
  state.heat_under_way = state.heat_for_all = 0;
}

void note_squares(Grid& grid) {
  for (const int node : grid.active_nodes) {
    const auto n = static_cast<std::size_t>(node);
    grid.squares[n] = squared(grid.convected[n]) + squared(grid.motion.u[n]);
  }
  grid.unfold_squares();
}

}  // namespace tether::mpm
