// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>

#include "algebra/sparse_matrix.hpp"

namespace tether {

/// Preconditioner for symmetric positive definite matrices such as those of pressures on a grid, whose rows sum to
/// about 0 or more: one cycle of multigrid whose coarse unknowns are aggregates of fine ones, found by the matrix
/// alone.
class AggregationMultigrid {
 public:
  AggregationMultigrid();
  ~AggregationMultigrid();
  AggregationMultigrid(AggregationMultigrid&&) noexcept;
  AggregationMultigrid& operator=(AggregationMultigrid&&) noexcept;

  /// Makes the levels of A, both triangles of which must be there. False where a diagonal entry is not positive.
  bool set_up(const SparseMatrix& A);
  /// z = P^-1 r, each of A.n numbers, symmetric positive definite, for pcg.
  void precondition(std::span<const double> r, std::span<double> z);

  int levels() const;
  double complexity() const;  ///< nonzeros of all levels' matrices over those of A

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace tether
