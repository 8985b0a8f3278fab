// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/SparseCore>
#include <cstdint>

#include "algebra/sparse_matrix.hpp"

namespace tether {

/// Eigen's matrix by compressed columns with the indices that SparseMatrix has.
using EigenSparse = Eigen::SparseMatrix<double, Eigen::ColMajor, std::int64_t>;
/// The same by compressed rows.
using EigenRows = Eigen::SparseMatrix<double, Eigen::RowMajor, std::int64_t>;

/// Shows the same numbers to Eigen, for its products.
inline Eigen::Map<const EigenSparse> eigen_of(const SparseMatrix& A) {
  return {A.n, A.n, static_cast<Eigen::Index>(A.value.size()), A.start.data(), A.row.data(), A.value.data()};
}

/// Takes over the numbers of a square one, whose columns are compressed.
inline SparseMatrix sparse_of(const EigenSparse& A) {
  return {A.rows(),
          {A.outerIndexPtr(), A.outerIndexPtr() + A.outerSize() + 1},
          {A.innerIndexPtr(), A.innerIndexPtr() + A.nonZeros()},
          {A.valuePtr(), A.valuePtr() + A.nonZeros()}};
}

}  // namespace tether
