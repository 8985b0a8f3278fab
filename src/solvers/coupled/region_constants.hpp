// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "algebra/quasidefinite_solver.hpp"
#include "solvers/coupled/coupled_matrix.hpp"

namespace tether::coupled {

/// The constant pressures c that equations of pressures alone do not feel and free velocities do: one of each closed
/// region that is not loose. W has a column for each, 1 in its region.
class ConstantPressures {
 public:
  ConstantPressures() = default;
  explicit ConstantPressures(const CoupledEquations& equations);

  std::size_t count() const { return cells_.size(); }
  /// The c of a pressure, or -1.
  int of(std::size_t pressure) const { return of_[pressure]; }
  /// sums += W^T x.
  void add_sums(std::span<const double> x, std::span<double> sums) const;
  /// p += W c.
  void add(std::span<const double> c, std::span<double> p) const;
  /// Takes the means over the regions off, and tells them.
  std::vector<double> take_means(std::span<double> p) const;

 private:
  std::vector<int> of_;
  std::vector<double> cells_;  // of each c how many pressures
};

/// They as a border of the other equations.
class RegionConstants {
 public:
  RegionConstants(const CoupledEquations& equations, const ReducedEquations& with);

  /// c. `x` has the solution of the other equations by `factors`, velocities first, and is corrected.
  std::vector<double> found(QuasidefiniteSolver& factors, std::span<double> x) const;
  const ConstantPressures& constants() const { return constants_; }

 private:
  ConstantPressures constants_;
  std::vector<std::vector<double>> border_;  // of each constant its column S
  std::vector<double> right_;                // of each the sum of r
};

}  // namespace tether::coupled
