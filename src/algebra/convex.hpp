// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace tether {

/// Returns whether a symmetric matrix is positive semi-definite but for rounding: what is negative by so little of the
/// trace is no more so by what is taken off.
template <class Matrix>
bool is_convex(const Matrix& H) {
  constexpr double rounding = 1e-13;
  double trace = 0;
  for (Eigen::Index k = 0; k < H.rows(); ++k) trace += H(k, k);
  Matrix raised = H;
  for (Eigen::Index k = 0; k < H.rows(); ++k) raised(k, k) += rounding * trace;
  return Eigen::LLT<Matrix>(raised).info() == Eigen::Success;
}

/// The positive semi-definite matrix nearest to a symmetric one.
template <class Matrix>
Matrix nearest_convex(const Matrix& H) {
  if (is_convex(H)) return H;
  const Eigen::SelfAdjointEigenSolver<Matrix> parts(H);
  if (parts.eigenvalues()[0] >= 0) return H;
  return parts.eigenvectors() * parts.eigenvalues().cwiseMax(0).asDiagonal() * parts.eigenvectors().transpose();
}

}  // namespace tether
