// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace tether {

// Small dense systems whose size is known at run time, each by one factorisation of Eigen. They are compiled here once:
// a factorisation costs its user seconds of the compiler's time.

/// x of A x = b, A square and regular, by LU with rows exchanged.
Eigen::VectorXd solve(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

/// x of A x = b, A symmetric, by L D L^T; of a singular A and a b in its range, one of the solutions.
Eigen::VectorXd solve_symmetric(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

/// The x of smallest |b - A x|, of an A with more rows than columns, by QR with columns exchanged.
Eigen::VectorXd least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

/// The smallest x of those of smallest |b - A x|.
Eigen::VectorXd smallest_solution(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

/// The matrix that gives smallest_solution() for any b.
Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& A);

/// The positive semi-definite matrix nearest to the symmetric part of A.
Eigen::MatrixXd convex_part(const Eigen::MatrixXd& A);

/// Eigenvalues of a symmetric A, ascending, and its eigenvectors of length 1, a column each.
struct EigenParts {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};
EigenParts eigen_parts(const Eigen::MatrixXd& A);

/// Columns that are independent: of a QR with columns exchanged, those whose pivot is above `threshold` of the largest.
Eigen::Index rank(const Eigen::MatrixXd& A, double threshold);

}  // namespace tether
