// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>

#include "algebra/aggregates.hpp"
#include "algebra/sparse_matrix.hpp"
#include "base/team.hpp"

namespace tether {

/// Preconditioner for symmetric positive definite matrices such as those of pressures on a grid, most of whose
/// couplings are negative: one cycle of multigrid whose coarse unknowns are aggregates of fine ones, found by the
/// matrix alone. On each level a forward sweep of Gauss and Seidel, a correction by the coarser level, a backward
/// sweep; the coarser levels are solved by two iterations of conjugate gradients, preconditioned in the same way, which
/// makes up for the coarse functions being only constant in pieces (the K-cycle). The coarsest is solved directly.
/// Sources: Y. Notay, P. S. Vassilevski, Numer. Linear Algebra Appl. 15 (2008) 473-487; Y. Notay, ETNA 37 (2010)
/// 123-146.
class AggregationMultigrid {
 public:
  /// The team shares its loops, and must outlive it.
  explicit AggregationMultigrid(Team& team);
  ~AggregationMultigrid();
  AggregationMultigrid(AggregationMultigrid&&) noexcept;
  AggregationMultigrid& operator=(AggregationMultigrid&&) noexcept;

  /// Makes the levels of A, both triangles of which must be there. Rows without couplings and parts that are singular
  /// (pockets of pressure without an outlet) are taken. False where a diagonal entry is not positive, or the coarsest
  /// matrix is no use.
  bool set_up(const SparseMatrix& A) { return make_levels(rows_of(A)) && factorise(); }
  /// Does the same in two parts, of which only the second one calls BLAS, which is not made for two threads at once.
  bool make_levels(SymmetricRows A);
  bool factorise();
  /// z = P^-1 r, each of A.n numbers and apart; P is symmetric positive definite but for what two inner iterations
  /// vary, which pcg forgives.
  void precondition(std::span<const double> r, std::span<double> z);

  int levels() const;
  double complexity() const;  ///< nonzeros of all levels' matrices over those of A

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace tether
