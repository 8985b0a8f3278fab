// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "algebra/sparse_matrix.hpp"
#include "model/solids.hpp"

namespace tether::fem {

/// The inertia that immersed solids have more than the fluid in their place, (rho_s - rho_f) dv/dt of (49), at solid
/// nodes: 2 numbers each. dv/dt = (v1 - v0)/dt + (v_t . grad) v_t where the fluid is asked, v_t and its gradient those
/// of the solid's own functions, whose slopes do not jump within an element as the fluid's do.
class ExcessInertia {
 public:
  virtual ~ExcessInertia() = default;
  /// Adds the forces at nodes that stand at x, move with v and are accelerated by `rate`, (v1 - v0)/dt.
  virtual void add_forces(std::span<const double> x, std::span<const double> v, std::span<const double> rate,
                          std::span<double> f) const = 0;
  /// Adds `by_rate` times their derivative by the rate and `by_velocity` times that by v.
  virtual void add_tangent(std::span<const double> x, std::span<const double> v, double by_rate, double by_velocity,
                           const NodalPattern& pattern, SparseMatrix& S) const = 0;
};

/// Of solids whose densities are those less the fluid's; null where all are the fluid's own. They must outlive it.
std::unique_ptr<ExcessInertia> make_excess_inertia(const Solids& excess);

}  // namespace tether::fem
