// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <variant>
#include <vector>

#include "loops/points.hpp"
#include "physics/points/elements.hpp"
#include "physics/points/nodes.hpp"
#include "physics/points/passes.hpp"
#include "physics/points/state.hpp"
#include "physics/points/steps.hpp"

namespace tether::mpm {

// Passes of membranes whose forces come from elements, of what the ledger books of them, and of gas at the nodes where
// points have moved meanwhile.

/// Forces of the points, spread by N. A pin takes what pulls at it.
template <class S>
inline void spread_forces(const Points& P, const Locator& locator, const Elements& elements, NodeSumsRow& sums) {
  for_points(elements.range(), [&](std::size_t p) {
    if (P.pinned[p]) return;
    const auto at = S::Kernel::locate(locator, P.x[p], P.y[p]);
    const auto nodes = S::Kernel::nodes(locator, at);
    const auto N = S::Kernel::values(at);
    for (std::size_t k = 0; k < S::Kernel::size; ++k) sums.force[nodes[k]] += N[k] * elements.force(p);
  });
}

/// Strains and stresses of the elements, and their forces on the nodes.
template <class S>
[[nodiscard]] inline Trouble pull_elements(const PassWork& work, Elements& elements) {
  std::size_t bad = 0;
  if (!elements.update(work.P, bad)) return {TroubleKind::unsound, bad};
  spread_forces<S>(work.P, work.locator, elements, work.grid.sums);
  return {};
}

/// The pressure outside on a membrane whose stress is its points'.
template <class S>
inline void press_ambient(const PassWork& work, Elements& elements) {
  elements.update_ambient(work.P);
  spread_forces<S>(work.P, work.locator, elements, work.grid.sums);
}

/// Velocities, new places, mass and momentum; with the ledger also what the point's forces gave on the way.
template <class S>
inline StepFindings accelerate_move_and_map_membrane(const PassWork& work, Elements& elements, bool ledger,
                                                     const StepFindings& before) {
  Points& P = work.P;
  const double dt = work.step.dt;
  return find_at_points(elements.range(), before, [&](std::size_t p, StepFindings& found) {
    if (P.pinned[p]) {
      elements.book(p, pair(P.x[p], P.y[p]), Pair{}, 0);
      return;
    }
    auto at = S::Kernel::locate(work.locator, P.x[p], P.y[p]);
    const auto nodes = S::Kernel::nodes(work.locator, at);
    if (ledger) {
      const auto middle = [&](std::size_t n) {
        return 0.5 * (Pair(work.grid.convected[n]) + Pair(work.grid.motion.u[n]));
      };
      const Pair moved = dt * S::Kernel::value(at, nodes, middle);
      const double lost = P.mass[p] * accelerate_and_book<S>(P, p, work.grid, work.locator, at, nodes, found.squares);
      elements.book(p, pair(P.x[p], P.y[p]), moved, lost);
    } else {
      accelerate<S>(P, p, dt, work.grid.motion, work.locator, at, nodes, found.squares);
    }
    move<S>(P, p, dt, work.grid.motion, at, nodes, found.lifted);
    if (accept_place<typename S::Kernel>(P, p, work.locator, work.grid.frame, at, found)) {
      map_momentum<S>(P, p, work.grid.sums, work.locator, at, S::Kernel::nodes(work.locator, at));
    }
  });
}

/// Gives energy to the gas around a place, to each node's in the measure of N_i rho_gas, so that the node of a wall
/// counts as much as if there were none; where there is no gas, to all of it.
template <class S>
inline void heat_gas_around(const PassWork& work, State& state, std::size_t p, double energy) {
  const Grid& grid = work.grid;
  const auto at = S::Kernel::locate(work.locator, work.P.x[p], work.P.y[p]);
  const auto nodes = S::Kernel::nodes(work.locator, at);
  const auto N = S::Kernel::values(at);
  double rho = 0;
  for (std::size_t k = 0; k < S::Kernel::size; ++k) {
    const std::size_t n = grid.frame.image[nodes[k]];
    rho += N[k] * grid.sums.gas[n] * grid.frame.per_volume[n];
  }
  if (!(rho > 0)) return give_to_all_gas(state, energy);
  state.heat_under_way += energy;
  state.heat_given += energy;
  for (std::size_t k = 0; k < S::Kernel::size; ++k) {
    const std::size_t n = grid.frame.image[nodes[k]];
    work.grid.loss[n] += energy * N[k] * grid.sums.gas[n] * grid.frame.per_volume[n] / rho;
  }
}

/// Gives what gas and membranes lost in this step to the gas, which takes it at the beginning of the next one.
template <class S>
inline void settle_ledger(StepWork& work, const PassWork& pass) {
  State& state = work.state;
  state.grid.fold_loss();
  for (auto& elements : state.elements_of) {
    if (!elements) continue;
    elements->settle(state.points);
    for_points(elements->range(), [&](std::size_t p) { heat_gas_around<S>(pass, state, p, elements->heat(p)); });
  }
}

/// Density of gas at the nodes of its present places, sum_p m_p N_i / V_i.
template <class S>
inline void density_at_nodes(const PassWork& work, const std::vector<Slots>& gas) {
  if (gas.empty()) return;
  const Points& P = work.P;
  const auto each = [&](const auto& visit) {
    for (const Slots range : gas) {
      for_points(P, range, [&](std::size_t p) {
        const auto at = S::Kernel::locate(work.locator, P.x[p], P.y[p]);
        visit(p, S::Kernel::nodes(work.locator, at), S::Kernel::values(at));
      });
    }
  };
  each([&](std::size_t, const auto& nodes, const auto&) {
    for (const std::size_t n : nodes) work.grid.gas.rho[n] = work.grid.gas.rho[work.grid.frame.image[n]] = 0;
  });
  each([&](std::size_t p, const auto& nodes, const auto& N) {
    for (std::size_t k = 0; k < S::Kernel::size; ++k) {
      const std::size_t n = work.grid.frame.image[nodes[k]];
      work.grid.gas.rho[n] += N[k] * P.mass[p] * work.grid.frame.per_volume[n];
    }
  });
  work.grid.unfold_gas();
}

// What is written of gas that takes its density from the nodes.

/// Calls visit(gas, p, nodes, N) for each point of the gas that takes its density from the nodes.
template <class S, class Visit>
void each_gas_by_nodes(const State& state, const Scene& scene, const Visit& visit) {
  const Locator locator(state.grid.frame.shape);
  const Points& P = state.points;
  for (std::size_t b = 0; b < state.ranges.size(); ++b) {
    const auto* gas = std::get_if<IdealGas>(&scene.bodies[b].material);
    if (!gas || !from_nodes(*gas)) continue;
    for_points(P, state.ranges[b], [&](std::size_t p) {
      const auto at = S::Kernel::locate(locator, P.x[p], P.y[p]);
      visit(*gas, p, S::Kernel::nodes(locator, at), S::Kernel::values(at));
    });
  }
}

/// The force of such gas on a node is sum_p m_p (gamma - 1) i_p G_ip: of a pressure p_i = sum_p m_p (gamma - 1) i_p N_i
/// / V_i at the nodes, whatever the densities, and of p_p = sum_i N_i p_i at a point. Where gases of other densities
/// meet, (gamma - 1) rho_p i_p with the density from the nodes is another number, and no force has it.
template <class S>
std::vector<double> gas_pressures(const State& state, const Scene& scene) {
  if (state.gas_by_nodes.empty()) return {};
  const Frame& frame = state.grid.frame;
  const Points& P = state.points;
  std::vector<double> at_nodes(frame.shape.nodes(), 0.0), pressures(P.size(), 0.0);
  each_gas_by_nodes<S>(state, scene, [&](const IdealGas& gas, std::size_t p, const auto& nodes, const auto& N) {
    const double part = P.mass[p] * gas.gm1 * P.energy[p];
    for (std::size_t k = 0; k < S::Kernel::size; ++k) {
      const std::size_t n = frame.image[nodes[k]];
      at_nodes[n] += part * N[k] * frame.per_volume[n];
    }
  });
  each_gas_by_nodes<S>(state, scene, [&](const IdealGas&, std::size_t p, const auto& nodes, const auto& N) {
    for (std::size_t k = 0; k < S::Kernel::size; ++k) pressures[p] += N[k] * at_nodes[frame.image[nodes[k]]];
  });
  return pressures;
}

}  // namespace tether::mpm
