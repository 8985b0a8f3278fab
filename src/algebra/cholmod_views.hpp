// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cholmod.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "algebra/sparse_matrix.hpp"
#include "base/diagnostics.hpp"

namespace tether {

[[noreturn]] inline void out_of_memory(const SparseMatrix& A) {
  throw RunError("the memory does not hold the factors of a matrix of " + std::to_string(A.n) + " unknowns");
}

/// The libraries want pointers to what they only read.
inline SuiteSparse_long* as_long(const std::vector<std::int64_t>& indices) {
  static_assert(sizeof(SuiteSparse_long) == sizeof(std::int64_t));
  return reinterpret_cast<SuiteSparse_long*>(const_cast<std::int64_t*>(indices.data()));
}

/// The pattern of a symmetric matrix of n unknowns, of which CHOLMOD reads the lower triangle.
inline cholmod_sparse lower_view(std::size_t n, const std::vector<std::int64_t>& start,
                                 const std::vector<std::int64_t>& row) {
  cholmod_sparse matrix{};
  matrix.nrow = matrix.ncol = n, matrix.nzmax = row.size();
  matrix.p = as_long(start), matrix.i = as_long(row);
  matrix.stype = -1, matrix.itype = CHOLMOD_LONG, matrix.xtype = CHOLMOD_PATTERN, matrix.dtype = CHOLMOD_DOUBLE;
  matrix.sorted = matrix.packed = 1;
  return matrix;
}

/// The symmetric matrix with the lower triangle of A.
inline cholmod_sparse lower_view(const SparseMatrix& A) {
  cholmod_sparse matrix = lower_view(static_cast<std::size_t>(A.n), A.start, A.row);
  matrix.x = const_cast<double*>(A.value.data()), matrix.xtype = CHOLMOD_REAL;
  return matrix;
}

/// x = A^-1 b by a numerical factor of A; b and x may be the same. Throws RunError where memory does not do.
inline void solve_by(cholmod_factor* factor, std::span<const double> b, std::span<double> x, cholmod_common& common) {
  cholmod_dense right{};
  right.nrow = right.d = right.nzmax = b.size(), right.ncol = 1;
  right.x = const_cast<double*>(b.data());
  right.xtype = CHOLMOD_REAL, right.dtype = CHOLMOD_DOUBLE;
  cholmod_dense* solution = cholmod_l_solve(CHOLMOD_A, factor, &right, &common);
  if (!solution) throw RunError("the memory does not hold a solution of " + std::to_string(b.size()) + " unknowns");
  const auto* found = static_cast<const double*>(solution->x);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = found[i];
  cholmod_l_free_dense(&solution, &common);
}

}  // namespace tether
