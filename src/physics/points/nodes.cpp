// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/points/nodes.hpp"

#include <array>
#include <utility>

#include "physics/points/balance.hpp"

namespace tether::mpm {

namespace {

NodeRows rows_of(Grid& grid) {
  return {.m = grid.sums.m.data(),
          .momentum_x = grid.sums.momentum.x.data(),
          .momentum_y = grid.sums.momentum.y.data(),
          .force_x = grid.sums.force.x.data(),
          .force_y = grid.sums.force.y.data(),
          .convected_x = grid.convected.x.data(),
          .convected_y = grid.convected.y.data(),
          .a_x = grid.motion.a.x.data(),
          .a_y = grid.motion.a.y.data(),
          .u_x = grid.motion.u.x.data(),
          .u_y = grid.motion.u.y.data()};
}

/// Runs a pass over pieces of the active nodes by all threads.
template <class Pass>
void each_piece(const State& state, const Pass& pass) {
  const ActiveNodes& active = state.grid.active;
  state.team->each(0, active.pieces(), [&](std::size_t k) { pass(active.piece(k)); });
}

void clear(State& state, std::span<double* const> rows) {
  each_piece(state, [&](std::span<const NodeSpan> nodes) { state.grid.passes.clear(rows, nodes); });
}

/// Takes the components that walls hold out of a field.
void hold(const Frame& frame, PairRow& field) {
  for (const std::size_t n : frame.at_walls) {
    if (frame.held[n] & holds_x) field.x[n] = 0;
    if (frame.held[n] & holds_y) field.y[n] = 0;
  }
}

LaneTotals solve_at_nodes(StepWork& work, double dt, Sums after) {
  Grid& grid = work.state.grid;
  const NodeStep step{.gravity = work.scene.gravity,
                      .dt = dt,
                      .light = work.state.light_node,
                      .held = grid.frame.held.data(),
                      .clears = after == Sums::cleared};
  std::vector<LaneTotals>& found = work.state.node_findings;
  found.resize(grid.active.pieces());
  work.state.team->each(
      0, found.size(), [&](std::size_t k) { found[k] = grid.passes.solve(rows_of(grid), grid.active.piece(k), step); });
  grid.unfold_motion();
  LaneTotals totals;
  for (const LaneTotals& piece : found) totals.join(piece);
  return totals;
}

}  // namespace

void solve_momentum(StepWork& work, double dt, Sums after) {
  const Grid& grid = work.state.grid;
  if (work.scene.method.transfer == Transfer::apic) {  // FLIP gives the nodes increments alone
    for (const std::size_t n : grid.frame.at_walls) work.nodes.add_held(grid.sums[n], grid.frame.held[n]);
  }
  const LaneTotals totals = solve_at_nodes(work, dt, after);
  work.nodes.power += totals.power, work.nodes.squares += totals.squares;
  work.nodes.gained += totals.gained, work.nodes.upward += totals.upward;
}

void solve_common_field(StepWork& work, double dt) { solve_at_nodes(work, dt, Sums::kept); }

void total_with_contact(StepWork& work, double dt) {
  const Contact& contact = work.state.contact;
  const Grid& grid = work.state.grid;
  work.nodes.light = work.state.light_node;
  for_nodes(grid.active, [&](std::size_t n) {
    if (contact.slot(n) < 0) work.nodes.add(grid.sums[n], grid.motion[n], grid.frame.held[n], dt);
  });
  work.nodes.light = 0;  // impulses have work of their own
  contact.total(work.nodes, grid.frame, dt);
}

void divide_convected(State& state) {
  Grid& grid = state.grid;
  each_piece(state, [&](std::span<const NodeSpan> nodes) { grid.passes.divide_convected(rows_of(grid), nodes); });
  hold(grid.frame, grid.convected);
  grid.unfold_convected();
}

void mapped_velocity(State& state) {
  Grid& grid = state.grid;
  each_piece(state, [&](std::span<const NodeSpan> nodes) { grid.passes.map_velocity(rows_of(grid), nodes); });
  hold(grid.frame, grid.convected);
  grid.unfold_convected();
}

void clear_convected(State& state) {
  Grid& grid = state.grid;
  clear(state, std::array{grid.convected.x.data(), grid.convected.y.data()});
  for (const Ghost& ghost : grid.ghosts) grid.convected[static_cast<std::size_t>(ghost.node)] = Pair{};
}

void clear_sums(State& state) {
  NodeSumsRow& sums = state.grid.sums;
  clear(state, std::array{sums.m.data(), sums.gas.data(), sums.momentum.x.data(), sums.momentum.y.data(),
                          sums.force.x.data(), sums.force.y.data()});
}

void map_anew(State& state, const Scene& scene, const StepSet& set) {
  Grid& grid = state.grid;
  const ActiveNodes before = grid.active;
  set.list_active(state);
  set.map_all(state, scene, grid.sums);
  if (grid.loss.empty()) return;
  for_nodes(before, [&](std::size_t n) {
    if (grid.loss[n] == 0 || grid.sums.m[n] > 0) return;
    state.heat_under_way -= grid.loss[n];
    state.strips.book_lost_heat(grid.loss[n]);
    grid.loss[n] = 0;
  });
}

void forget_sums(State& state, const StepSet& set) {
  clear_sums(state);
  set.list_active(state);
  clear_sums(state);
}

void clear_forces(State& state) {
  clear(state, std::array{state.grid.sums.force.x.data(), state.grid.sums.force.y.data()});
}

void gas_at_nodes(State& state) {
  Grid& grid = state.grid;
  for_nodes(*state.team, grid.active, [&](std::size_t n) {
    const double gas = std::exchange(grid.sums.gas[n], 0);  // nobody asks again
    grid.gas.rho[n] = gas * grid.frame.per_volume[n];
    if (!grid.loss.empty()) grid.gas.heat[n] = grid.loss[n] * inverse(gas);
  });
  grid.unfold_gas();
}

void give_to_all_gas(State& state, double energy) {
  state.heat_under_way += energy;
  state.heat_for_all += energy;
  state.heat_given += energy;
}

void clear_heat(State& state) {
  Grid& grid = state.grid;
  for_nodes(*state.team, grid.active, [&](std::size_t n) { grid.loss[n] = 0; });
  state.heat_under_way = state.heat_for_all = 0;
}

void note_squares(State& state) {
  Grid& grid = state.grid;
  for_nodes(*state.team, grid.active,
            [&](std::size_t n) { grid.squares[n] = squared(grid.convected[n]) + squared(grid.motion.u[n]); });
  grid.unfold_squares();
}

}  // namespace tether::mpm
