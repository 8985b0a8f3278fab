// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/dense.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>

#include "algebra/convex.hpp"

namespace tether {

Eigen::VectorXd solve(const Eigen::MatrixXd& A, const Eigen::VectorXd& b) { return A.partialPivLu().solve(b); }

Eigen::VectorXd solve_symmetric(const Eigen::MatrixXd& A, const Eigen::VectorXd& b) { return A.ldlt().solve(b); }

Eigen::VectorXd least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b) {
  return A.colPivHouseholderQr().solve(b);
}

Eigen::VectorXd smallest_solution(const Eigen::MatrixXd& A, const Eigen::VectorXd& b) {
  return A.completeOrthogonalDecomposition().solve(b);
}

Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& A) { return A.completeOrthogonalDecomposition().pseudoInverse(); }

EigenParts eigen_parts(const Eigen::MatrixXd& A) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> parts(A);
  return {parts.eigenvalues(), parts.eigenvectors()};
}

Eigen::MatrixXd convex_part(const Eigen::MatrixXd& A) {
  const Eigen::MatrixXd symmetric = 0.5 * (A + A.transpose());
  if (is_convex(symmetric)) return symmetric;
  const EigenParts parts = eigen_parts(symmetric);
  if (parts.values[0] >= 0) return symmetric;
  return parts.vectors * parts.values.cwiseMax(0).asDiagonal() * parts.vectors.transpose();
}

Eigen::Index rank(const Eigen::MatrixXd& A, double threshold) {
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(A);
  qr.setThreshold(threshold);
  return qr.rank();
}

}  // namespace tether
