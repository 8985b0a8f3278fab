// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/mpm/edge_gas.hpp"

#include <cmath>

#include "reference/riemann.hpp"

namespace tether::mpm {
namespace {

bool has_waves(const EdgeGas& gas) {
  return gas.density > 0 && gas.pressure > 0 && std::isfinite(gas.density) && std::isfinite(gas.pressure) &&
         std::isfinite(gas.across);
}

/// Whether the two part so fast that nothing is left between them, Toro (4.40).
bool parts(const EdgeGas& outside, const EdgeGas& inside, double gamma) {
  const auto c = [gamma](const EdgeGas& gas) { return std::sqrt(gamma * gas.pressure / gas.density); };
  return inside.across - outside.across >= 2 / (gamma - 1) * (c(outside) + c(inside));
}

}  // namespace

EdgeGas gas_on_edge(const Edge& edge, const EdgeGas& outside, const EdgeGas& inside, double gamma) {
  if (edge.kind == EdgeKind::outflow && !edge.has_outside) return inside;
  if (!has_waves(inside) || !has_waves(outside) || parts(outside, inside, gamma))
    return edge.kind == EdgeKind::inflow ? outside : inside;
  const RiemannSolution solution = solve_riemann({{outside.density, outside.across, outside.pressure},
                                                  {inside.density, inside.across, inside.pressure},
                                                  gamma,
                                                  0});
  const GasSample here = sample(solution, 0, 1);
  return {here.density, here.velocity, here.velocity > 0 ? outside.along : inside.along, here.pressure};
}

}  // namespace tether::mpm
