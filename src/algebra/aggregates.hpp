// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "algebra/eigen_sparse.hpp"
#include "algebra/sparse_matrix.hpp"
#include "base/team.hpp"

namespace tether {

/// A symmetric matrix by rows, in less room than SparseMatrix takes: sweeps over it wait for memory.
struct SymmetricRows {
  int n = 0;
  std::vector<std::int64_t> start;   ///< n + 1: where each row begins in column and value
  std::vector<std::int64_t> middle;  ///< n: where its part right of the diagonal begins
  std::vector<std::int32_t>
      column;  ///< of a row, without the diagonal; ascending, unless a level of multigrid sorts them
  std::vector<double> value;
  std::vector<double> diagonal;
  std::vector<double> scale;  ///< the diagonal entries that came together in each diagonal entry, summed

  /// y = A x
  void multiply(Team& team, std::span<const double> x, std::span<double> y) const;
  /// Returns whether diagonal entry i is more than what rounding leaves of a pocket without an outlet.
  bool positive(std::size_t i) const { return diagonal[i] > 1e-12 * scale[i]; }
  double nonzeros() const { return static_cast<double>(column.size() + diagonal.size()); }
};

/// Returns the rows of a symmetric matrix with both triangles: A, or A + S.
SymmetricRows rows_of(const SparseMatrix& A);
SymmetricRows rows_of_sum(const SparseMatrix& A, const EigenSparse& S);
SparseMatrix columns_of(const SymmetricRows& A);

/// A number for each unknown, that of its aggregate, or `alone`.
struct Aggregates {
  static constexpr int alone = -1;  ///< its row is so dominated by the diagonal that a sweep solves for it
  std::vector<int> of;
  int count = 0;
};

/// The unknowns of each aggregate, ascending.
Lists members_of(const Aggregates& aggregates);

/// Aggregates of up to 8 unknowns by pairing three times: each unknown with the one it is most strongly and negatively
/// coupled with, if that is free and about as strong as its strongest coupling; then pairs with pairs. `coarse` becomes
/// the matrix of the aggregates, the sums of A's entries. Source: Y. Notay, ETNA 37 (2010) 123-146.
Aggregates aggregate(const SymmetricRows& A, SymmetricRows& coarse);

}  // namespace tether
