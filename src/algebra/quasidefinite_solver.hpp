// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "algebra/sparse_matrix.hpp"

namespace tether {

/// An order of elimination, and the nonzeros of the factor that it was found for.
struct EliminationOrder {
  std::vector<std::int64_t> unknowns;
  double nonzeros = 0;
};

/// Direct solution of K x = b where K is symmetric quasi-definite: some order of its unknowns makes it
/// [A, -B^T; -B, -L], A and L symmetric positive definite. Such a matrix has factors P K P^T = L D L^T with a diagonal
/// D for every order P, so that the order may be that of least fill (R. J. Vanderbei, SIAM J. Optim. 5 (1995) 100-113);
/// CHOLMOD's simplicial ones. The order is kept from matrix to matrix while their size stays and their patterns change
/// little; the symbolic factor is kept while the pattern stays.
class QuasidefiniteSolver {
 public:
  QuasidefiniteSolver();
  ~QuasidefiniteSolver();
  QuasidefiniteSolver(QuasidefiniteSolver&&) noexcept;
  QuasidefiniteSolver& operator=(QuasidefiniteSolver&&) noexcept;

  /// Reads the lower triangle of K with its diagonal; what stands above it may be there or not. False where a pivot is
  /// 0 or no number: there is nothing to solve with then. Throws RunError where memory does not do.
  bool factorise(const SparseMatrix& K);
  /// x of the matrix factorised last, K.n numbers; b and x may be the same. Refined once where the residual is more
  /// than rounding leaves.
  void solve(std::span<const double> b, std::span<double> x);

  /// The order that is kept; empty before the first factorisation. With it another solver gives the same numbers to
  /// the last bit, as the order is all that it has of the matrices before.
  const EliminationOrder& order() const;
  void keep_order(EliminationOrder order);

  /// Negative entries of D: as many as L has unknowns, whatever the order, if the matrix is quasi-definite.
  std::int64_t negative_pivots() const;
  double factor_nonzeros() const;  ///< of the last factorisation, those of L
  int analyses() const;            ///< symbolic factors made so far
  int orders() const;              ///< orders of elimination found so far

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace tether
