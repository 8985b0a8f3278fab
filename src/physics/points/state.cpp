// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/points/state.hpp"

#include <algorithm>

#include "loops/points.hpp"

namespace tether::mpm {

static_assert(lists_each_number_once<Balance>(Balance::rows()), "a number of the balance has no row, or two");

static_assert(lists_each_number_once<StateNumbers>(StateNumbers::rows()), "a number of the state has no row, or two");
namespace {

/// Sums at the nodes that points reach.
struct ActiveSums {
  std::vector<std::size_t> node;
  std::vector<std::size_t> begin, end;  // of each body, its slots
  std::vector<int> apart;               // what criterion 3 remembers
  std::vector<int> blocks;              // one body's after the other, each after its length
  double contact_lost = 0;              // and what impulses took
  std::vector<double> m, gas, momentum_x, momentum_y, force_x, force_y, loss;
  std::vector<double> element_force_x, element_force_y;  // on the points of membranes, of the last step
};

ActiveSums active_sums(const Grid& grid) {
  ActiveSums active;
  for_nodes(grid.active, [&](std::size_t n) {
    const NodeSums sum = grid.sums[n];
    active.node.push_back(n);
    active.m.push_back(sum.m);
    active.gas.push_back(sum.gas);
    active.loss.push_back(grid.loss.empty() ? 0 : grid.loss[n]);
    active.momentum_x.push_back(sum.momentum[0]);
    active.momentum_y.push_back(sum.momentum[1]);
    active.force_x.push_back(sum.force[0]);
    active.force_y.push_back(sum.force[1]);
  });
  return active;
}

void put_sums(const ActiveSums& active, Grid& grid) {
  for (std::size_t k = 0; k < active.node.size(); ++k) {
    const std::size_t n = active.node[k];
    NodeSumsAt sum = grid.sums[n];
    sum.m = active.m[k];
    sum.gas = active.gas[k];
    if (!grid.loss.empty()) grid.loss[n] = active.loss[k];
    sum.momentum = pair(active.momentum_x[k], active.momentum_y[k]);
    sum.force = pair(active.force_x[k], active.force_y[k]);
  }
}

/// Calls visit(elements) for those of every body that has some.
template <class AnyState, class Visit>
void each_elements(AnyState& state, const Visit& visit) {
  for (auto* of : {&state.elements_of, &state.ambient_of}) {
    for (auto& elements : *of) {
      if (elements) visit(*elements);
    }
  }
}

void take_forces(const State& state, ActiveSums& sums) {
  each_elements(state, [&](const Elements& elements) {
    for_points(elements.range(), [&](std::size_t p) {
      sums.element_force_x.push_back(elements.force(p)[0]), sums.element_force_y.push_back(elements.force(p)[1]);
    });
  });
}

void put_forces(const ActiveSums& sums, State& state) {
  std::size_t k = 0;
  each_elements(state, [&](Elements& elements) {
    for_points(elements.range(), [&](std::size_t p) {
      elements.set_force(p, pair(sums.element_force_x[k], sums.element_force_y[k])), ++k;
    });
  });
}

void take_blocks(const State& state, ActiveSums& sums) {
  for (const auto& blocks : state.blocks) {
    if (!blocks) continue;
    const std::vector<int> memory = blocks->memory();
    sums.blocks.push_back(static_cast<int>(memory.size()));
    sums.blocks.insert(sums.blocks.end(), memory.begin(), memory.end());
  }
}

void put_blocks(const ActiveSums& sums, State& state) {
  auto from = sums.blocks.begin();
  for (auto& blocks : state.blocks) {
    if (!blocks) continue;
    const auto length = *from++;
    blocks->remember({from, from + length});
    from += length;
  }
  state.empty_slots = static_cast<std::size_t>(std::count(state.points.id.begin(), state.points.id.end(), -1));
}

void take_ranges(const State& state, ActiveSums& sums) {
  for (const Slots range : state.ranges) sums.begin.push_back(range.begin), sums.end.push_back(range.end);
}

/// Arrays that no checkpoint has follow the others' length.
void put_ranges(const ActiveSums& sums, const Scene& scene, State& state) {
  const double gas_mass = state.gas_mass;
  state.points.each_array([n = state.points.x.size()](auto& array) { array.resize(n); });
  for (std::size_t b = 0; b < state.ranges.size(); ++b)
    state.ranges[b] = {sums.begin[b], sums.end[b], state.blocks[b].has_value()};
  state.list_fluids(scene);
  state.gas_mass = gas_mass;  // to the last bit: it was added up in another order
  state.strips.find_gas_on_edges();
}

/// The list of what a state consists of, once for both ways.
template <class Exchange, class AnyState, class Sums>
void exchange(Exchange& with, AnyState& state, Sums& sums) {
  auto& P = state.points;
  each_row(Points::rows(), [&](const auto& row) {
    if (!row.remembered() || !row.carried_by(P)) return;
    if (state.strips.on() ||
        state.lane_passes)  // where gas passes the edges, or points stand in blocks, its length changes
      with.list(row.name, P.*row.array);
    else
      with(row.name, P.*row.array);
  });
  Strips::exchange(with, state.strips);
  exchange_clock(with, state);
  using Numbers = std::conditional_t<std::is_const_v<AnyState>, const StateNumbers, StateNumbers>;
  exchange_numbers(with, static_cast<Numbers&>(state));
  exchange_numbers(with, state.balance);
  with("body_begin", sums.begin), with("body_end", sums.end);
  with.list("blocks", sums.blocks);
  with.list("active_nodes", sums.node);
  with.list("node_mass", sums.m), with.list("node_gas", sums.gas), with.list("node_loss", sums.loss);
  with.list("node_momentum_x", sums.momentum_x), with.list("node_momentum_y", sums.momentum_y);
  with.list("node_force_x", sums.force_x), with.list("node_force_y", sums.force_y);
  with.list("element_force_x", sums.element_force_x), with.list("element_force_y", sums.element_force_y);
  with.list("apart", sums.apart), with("contact_lost", sums.contact_lost);
}

}  // namespace

SavedState save(const State& state) {
  StateSaver saver;
  ActiveSums sums = active_sums(state.grid);
  sums.apart = state.contact.memory();
  sums.contact_lost = state.contact.lost();
  take_forces(state, sums);
  take_ranges(state, sums), take_blocks(state, sums);
  exchange(saver, state, sums);
  return saver.take();
}

void restore(State& state, const Scene& scene, const SavedState& saved) {
  for_nodes(state.grid.active, [&](std::size_t n) { state.grid.sums[n] = NodeSums{}; });
  StateRestorer restorer(saved);
  ActiveSums sums;
  take_ranges(state, sums);
  exchange(restorer, state, sums);
  put_ranges(sums, scene, state), put_blocks(sums, state);
  put_sums(sums, state.grid);
  state.contact.remember(sums.apart);
  state.contact.set_lost(sums.contact_lost);
  put_forces(sums, state);
}

}  // namespace tether::mpm
