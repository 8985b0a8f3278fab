// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solvers/mpm/kernels.hpp"

// The heat ledger: what a transfer between points and nodes loses of the kinetic energy. With the field C about a point
// its kinetic energy is m/2 sum_i N_i |v_p + C (x_i - x_p)|^2 = m/2 (|v_p|^2 + |C|^2 D), D = h^2/4 an axis for
// quadratic splines. What the nodes then have is less by the scatter of what the points gave them, m/2 sum N |v_p + C
// dx - v_old|^2, and what the points take back is less by the scatter of the nodes' velocities about the field, m/2 sum
// N |v_new - v_p' - C' dx|^2. Both are sums of squares: the transfer only ever loses.

namespace tether::mpm {

/// accelerate() for APIC by splines; returns the kinetic energy per mass that the point's transfers of this step lose,
/// to the nodes and back [velocity^2].
template <class S>
inline double accelerate_and_book(Points& P, std::size_t p, const Grid& grid, const Locator& locator,
                                  const typename S::Kernel::Place& at, const typename S::Kernel::Nodes& nodes,
                                  double& squares_of_points) {
  const LinearField given = field_about(P, p);
  const LinearField old = S::Kernel::affine(locator, at, nodes, [&](std::size_t n) { return grid.convected[n]; });
  accelerate<S>(P, p, 0, grid.motion, locator, at, nodes, squares_of_points);
  const LinearField taken = field_about(P, p);
  const auto N = S::Kernel::values(at);
  double squares = 0;
  for (std::size_t k = 0; k < S::Kernel::size; ++k) squares += N[k] * grid.squares[nodes[k]];
  return 0.5 * (product<S>(locator, given, given) - 2 * product<S>(locator, given, old) -
                product<S>(locator, taken, taken) + squares);
}

}  // namespace tether::mpm
