// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <string>

#include "algebra/sparse_matrix.hpp"
#include "base/process.hpp"

namespace tether {

/// What is known of a matrix. `positive` is a guess: where the factorisation finds it wrong, the general one is used.
enum class Definite { positive, general };

/// Direct solution of A x = b where A has a symmetric pattern: Cholesky (CHOLMOD, the lower triangle of A) for
/// symmetric positive definite matrices, LU (UMFPACK) for others. The symbolic analysis is kept while matrices have the
/// pattern of the one before.
class SparseSolver {
 public:
  /// `block`: unknowns of a node, which stand together in the pattern.
  explicit SparseSolver(int block = 1);
  /// Nodes with different numbers of unknowns: those of node A are block_start[A] .. block_start[A + 1] - 1. All of a
  /// node couple with the same nodes.
  explicit SparseSolver(std::vector<int> block_start);
  ~SparseSolver();
  SparseSolver(SparseSolver&&) noexcept;
  SparseSolver& operator=(SparseSolver&&) noexcept;

  /// Finds the order of elimination for matrices of this size once and for all by this one's pattern, though theirs may
  /// have some couplings more, which change.
  void order_by(const SparseMatrix& A);
  /// False where A is singular to working precision. Throws RunError where memory does not do.
  bool factorise(const SparseMatrix& A, Definite definite);
  /// x of the matrix factorised last; b and x may be the same.
  void solve(std::span<const double> b, std::span<double> x);

  double factor_nonzeros() const;  ///< of the last factorisation, L or L and U
  Seconds analysis() const;        ///< of all symbolic analyses so far
  std::string method() const;      ///< "cholesky" or "lu", of the last factorisation

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace tether
