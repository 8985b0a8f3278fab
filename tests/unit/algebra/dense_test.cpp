// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/dense.hpp"

#include <gtest/gtest.h>

namespace tether {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd tall() {
  MatrixXd A(4, 2);
  A << 1, 0, 1, 1, 1, 2, 1, 3;
  return A;
}

TEST(Dense, SolvesRegularSystems) {
  MatrixXd A(3, 3);
  A << 0, 2, 1, 3, -1, 2, 1, 1, 4;
  const VectorXd x = VectorXd::LinSpaced(3, -1, 2);
  EXPECT_LT((solve(A, A * x) - x).norm(), 1e-14);
  const MatrixXd S = A + A.transpose();
  EXPECT_LT((solve_symmetric(S, S * x) - x).norm(), 1e-13);
}

TEST(Dense, SymmetricOfRankOneKeepsToItsRange) {
  MatrixXd A(2, 2);
  A << 2, 2, 2, 2;
  const VectorXd b = VectorXd::Constant(2, 6);
  EXPECT_LT((A * solve_symmetric(A, b) - b).norm(), 1e-13);
}

/// The line of least squares through (0, 1), (1, 3), (2, 2), (3, 5), from the normal equations by hand: 1.1 + 1.1 t.
TEST(Dense, LeastSquaresIsTheRegressionLine) {
  VectorXd b(4);
  b << 1, 3, 2, 5;
  const VectorXd line = least_squares(tall(), b);
  EXPECT_NEAR(line[0], 1.1, 1e-14);
  EXPECT_NEAR(line[1], 1.1, 1e-14);
  EXPECT_LT((smallest_solution(tall(), b) - line).norm(), 1e-14);
  EXPECT_LT((pseudo_inverse(tall()) * b - line).norm(), 1e-14);
}

/// Of all x with x0 + x1 = 2 the smallest is (1, 1).
TEST(Dense, SmallestOfManySolutions) {
  const MatrixXd A = MatrixXd::Ones(1, 2);
  EXPECT_LT((smallest_solution(A, VectorXd::Constant(1, 2)) - VectorXd::Ones(2)).norm(), 1e-14);
}

/// (2, 1; 1, 2) stretches (1, -1) by 1 and (1, 1) by 3.
TEST(Dense, EigenPartsAscend) {
  MatrixXd A(2, 2);
  A << 2, 1, 1, 2;
  const EigenParts parts = eigen_parts(A);
  EXPECT_NEAR(parts.values[0], 1, 1e-14);
  EXPECT_NEAR(parts.values[1], 3, 1e-14);
  EXPECT_NEAR(parts.vectors(0, 0), -parts.vectors(1, 0), 1e-14);
  EXPECT_LT((A * parts.vectors - parts.vectors * parts.values.asDiagonal()).norm(), 1e-14);
}

TEST(Dense, RankCountsWhatIsAboveTheThreshold) {
  MatrixXd A = MatrixXd::Identity(3, 3);
  EXPECT_EQ(rank(A, 1e-12), 3);
  A(2, 2) = 1e-13;
  EXPECT_EQ(rank(A, 1e-12), 2);
  EXPECT_EQ(rank(MatrixXd::Ones(3, 3), 1e-12), 1);
}

}  // namespace
}  // namespace tether
