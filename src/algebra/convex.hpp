// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace tether {

/// Returns whether a symmetric matrix is positive semi-definite but for rounding, by the pivots of its elimination:
/// what is negative by so little of the trace is no more so by what is taken off.
template <class Matrix>
bool is_convex(const Matrix& H) {
  constexpr double rounding = 1e-13;
  const double raised = rounding * H.trace();
  Matrix left = H;
  for (Eigen::Index k = 0; k < H.rows(); ++k) {
    const double pivot = left(k, k) + raised;
    if (pivot <= 0) return false;
    for (Eigen::Index j = k + 1; j < H.rows(); ++j) {
      const double part = left(j, k) / pivot;
      for (Eigen::Index i = j; i < H.rows(); ++i) left(i, j) -= part * left(i, k);
    }
  }
  return true;
}

}  // namespace tether
