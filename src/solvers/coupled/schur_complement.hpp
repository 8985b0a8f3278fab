// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>

#include "algebra/aggregation_multigrid.hpp"
#include "algebra/gmres.hpp"
#include "algebra/sparse_solver.hpp"
#include "solvers/coupled/coupled_matrix.hpp"
#include "solvers/coupled/region_constants.hpp"

namespace tether::coupled {

/// The pressures by conjugate gradients with the solids taken out by factors of A:
/// (L + B A^-1 B^T) p = -r - B A^-1 b. Multigrid of L with the solids as if their nodes moved each on its own.
/// The constant pressures c of closed regions that solids feel are unknowns beside the others, p = x + W c with W the
/// regions' cells: L does not feel them, and of those that stiff solids need, rounding of L p would leave nothing else.
/// The equations of c are sums of those of x; x without means in these regions is the solution that is found. They are
/// preconditioned by W^T B A^-1 B^T W.
class SchurComplement {
 public:
  explicit SchurComplement(int dim) : solids_(dim) {}

  /// p has the first guess; u is what the pressures make of it.
  KrylovResult solve(const CoupledEquations& equations, const ReducedEquations& with, double tolerance,
                     std::span<double> u, std::span<double> p);
  /// L p = right, L with rows of pinned pressures.
  KrylovResult solve_pressures(const CoupledEquations& equations, std::span<const std::uint8_t> pinned,
                               std::span<const double> right, double tolerance, std::span<double> p);

 private:
  bool set_up(const CoupledEquations& equations, std::span<const std::uint8_t> pinned);
  void set_up_constants();
  void move_solids(std::span<const double> forces);
  void multiply(std::span<const double> x, std::span<double> y);
  void precondition(std::span<const double> r, std::span<double> z);

  SparseSolver solids_;
  std::int64_t ordered_ = 0;  // unknowns of the solids that their order is for
  CouplingMatrix B_;          // less what is held or pinned, as L_
  SparseMatrix L_;
  AggregationMultigrid multigrid_;
  ConstantPressures constants_;
  Eigen::MatrixXd stiffness_;  // of the solids against c, (W^T B A^-1 B^T W)^-1
  std::vector<double> whole_, forces_, moved_;
};

}  // namespace tether::coupled
