// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "algebra/aggregates.hpp"
#include "algebra/eigen_sparse.hpp"
#include "algebra/sparse_solver.hpp"

namespace tether {

/// What is smooth in the unknowns of a matrix, and which of them a sweep does not settle.
struct CoarseUnknowns {
  EigenRows interpolation;         ///< a row for each unknown, a column for each coarse one
  std::vector<std::size_t> stiff;  ///< unknowns that are so strongly coupled that they are solved for together
};

/// Preconditioner for symmetric positive definite matrices: a forward sweep of Gauss and Seidel, a direct solution of
/// the stiff unknowns, one of the coarse ones, the stiff ones again, a backward sweep.
class TwoLevelPreconditioner {
 public:
  /// Makes what it needs of A. False where a coarse or a stiff part has no factors. Calls BLAS.
  bool set_up(SymmetricRows A, const CoarseUnknowns& coarse);
  /// z = P^-1 r, each of A.n numbers and apart; P is symmetric positive definite.
  void precondition(std::span<const double> r, std::span<double> z);

 private:
  void sweep_forward(std::span<const double> r, std::span<double> z);
  void solve_stiff_first(std::span<double> z);
  void solve_coarse(std::span<double> z);
  void solve_stiff_again(std::span<const double> r, std::span<double> z);
  void sweep_backward(std::span<const double> r, std::span<double> z) const;
  void add_stiff(std::span<double> z);
  double sum_of(std::int64_t first, std::int64_t last, std::span<const double> z) const;
  double residual(std::size_t row, std::span<const double> r, std::span<const double> z) const;

  SymmetricRows A_;
  EigenRows interpolation_;
  std::vector<std::size_t> stiff_;
  SparseSolver of_coarse_, of_stiff_;
  std::vector<double> left_;  // r - A z of each unknown, as the coarse ones are solved for
  std::vector<double> coarse_, part_;
};

}  // namespace tether
