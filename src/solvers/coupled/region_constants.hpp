// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "algebra/quasidefinite_solver.hpp"
#include "solvers/coupled/coupled_matrix.hpp"

namespace tether::coupled {

/// The constant pressures of closed regions that solids feel: a border of the other equations.
class RegionConstants {
 public:
  RegionConstants(const CoupledEquations& equations, const ReducedEquations& with);

  /// The constant of each region, 0 where it is not closed or loose. `x` has the solution of the other equations by
  /// `factors`, velocities first, and is corrected.
  std::vector<double> found(QuasidefiniteSolver& factors, std::span<double> x) const;

 private:
  std::vector<int> number_;                  // of each region among the constants; -1 without one
  std::vector<std::vector<double>> border_;  // of each constant its column S
  std::vector<double> right_;                // of each the sum of r
};

}  // namespace tether::coupled
