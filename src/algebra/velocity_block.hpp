// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "algebra/sparse_matrix.hpp"
#include "algebra/sparse_solver.hpp"

namespace tether {

/// How a preconditioner solves for velocities: by LU factors; or by incomplete ones, ILU(0), which take no more room
/// than the matrix, are made in the time of some products with it, and suit matrices in which masses over the time step
/// and convection outweigh viscosity.
enum class VelocityMethod { complete, incomplete };

/// Approximate solution of A u = r for the velocities of nodes.
class VelocityBlock {
 public:
  /// Unknowns first[A] .. first[A + 1] - 1 are those of node A.
  VelocityBlock(VelocityMethod method, std::vector<int> first);
  VelocityBlock(const VelocityBlock&) = delete;
  VelocityBlock& operator=(const VelocityBlock&) = delete;

  /// False where A is singular, or for incomplete factors a pivot is zero.
  bool factorise(SparseMatrix A);
  /// u is linear in r, and apart from it.
  void solve(std::span<const double> r, std::span<double> u);
  double factor_nonzeros() const;

 private:
  bool factorise_in_place();
  void solve_in_place(std::span<const double> r, std::span<double> u) const;

  VelocityMethod method_;
  SparseMatrix A_;  // or its incomplete factors
  SparseSolver solver_;
  std::vector<std::size_t> diagonal_;  // where it stands in the incomplete factors
};

/// Rows and columns `kept` of A, ascending.
SparseMatrix principal_block(const SparseMatrix& A, std::span<const std::int64_t> kept);

}  // namespace tether
