// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <cstdint>
#include <vector>

#include "algebra/sparse_matrix.hpp"

namespace tether {

/// n numbers about 1, no two alike: a solution that is known.
inline std::vector<double> waves(std::int64_t n) {
  std::vector<double> x(static_cast<std::size_t>(n));
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = 1 + std::sin(1.7 * static_cast<double>(i));
  return x;
}

/// The matrix with its zeros.
inline Eigen::MatrixXd full_of(const SparseMatrix& A) {
  Eigen::MatrixXd full = Eigen::MatrixXd::Zero(A.n, A.n);
  for (std::int64_t j = 0; j < A.n; ++j) {
    for (auto k = A.start[static_cast<std::size_t>(j)]; k < A.start[static_cast<std::size_t>(j) + 1]; ++k)
      full(A.row[static_cast<std::size_t>(k)], j) = A.value[static_cast<std::size_t>(k)];
  }
  return full;
}

}  // namespace tether
