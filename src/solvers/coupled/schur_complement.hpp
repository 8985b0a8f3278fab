// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "algebra/aggregation_multigrid.hpp"
#include "algebra/gmres.hpp"
#include "algebra/sparse_solver.hpp"
#include "solvers/coupled/coupled_matrix.hpp"

namespace tether::coupled {

/// The pressures by conjugate gradients with the solids taken out by factors of A:
/// (L + B A^-1 B^T) p = -r - B A^-1 b. Multigrid of L with the solids as if their nodes moved each on its own.
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

  SparseSolver solids_;
  std::int64_t ordered_ = 0;  // unknowns of the solids that their order is for
  CouplingMatrix B_;          // less what is held or pinned, as L_
  SparseMatrix L_;
  AggregationMultigrid multigrid_;
};

}  // namespace tether::coupled
