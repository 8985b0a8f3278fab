// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <variant>
#include <vector>

#include "loops/points.hpp"
#include "solvers/mpm/passes.hpp"
#include "solvers/mpm/state.hpp"

// What is written of gas that takes its density from the nodes.

namespace tether::mpm {

/// Calls visit(gas, p, nodes, N) for each point of the gas that takes its density from the nodes.
template <class S, class Visit>
void each_gas_by_nodes(const State& state, const Scene& scene, const Visit& visit) {
  const Locator locator(state.grid.frame.shape);
  const Points& P = state.points;
  for (std::size_t b = 0; b < state.ranges.size(); ++b) {
    const auto* gas = std::get_if<IdealGas>(&scene.bodies[b].material);
    if (!gas || !from_nodes(*gas)) continue;
    for_points(state.ranges[b], [&](std::size_t p) {
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
