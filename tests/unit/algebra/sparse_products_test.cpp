// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/sparse_products.hpp"

#include <gtest/gtest.h>

namespace tether {
namespace {

using Eigen::MatrixXd;

/// About a third of its numbers are 0.
MatrixXd numbers(Eigen::Index rows, Eigen::Index columns) {
  MatrixXd A(rows, columns);
  for (Eigen::Index j = 0; j < columns; ++j) {
    for (Eigen::Index i = 0; i < rows; ++i) A(i, j) = (i + 2 * j) % 3 == 0 ? 0 : std::sin(1 + 3. * i + 5. * j);
  }
  return A;
}

SparseMatrix sparse(const MatrixXd& A) {
  SparseMatrix out;
  out.n = A.cols();
  out.start.assign(1, 0);
  for (Eigen::Index j = 0; j < A.cols(); ++j) {
    for (Eigen::Index i = 0; i < A.rows(); ++i) {
      if (A(i, j) != 0) out.row.push_back(i), out.value.push_back(A(i, j));
    }
    out.start.push_back(static_cast<std::int64_t>(out.row.size()));
  }
  return out;
}

TEST(SparseProducts, CongruentIsThatOfDenseMatrices) {
  const MatrixXd S = numbers(5, 5), E = numbers(5, 3);
  const EigenSparse of_sparse = congruent(EigenSparse(S.sparseView()), EigenSparse(E.sparseView()));
  EXPECT_LT((MatrixXd(of_sparse) - E.transpose() * S * E).norm(), 1e-15);
}

TEST(SparseProducts, WeightedSquareIsThatOfDenseMatrices) {
  const MatrixXd L = numbers(4, 4), B = numbers(4, 6);
  const std::vector<double> D{1, 2, 0.5, 4, 8, 3};
  const SparseMatrix sum = plus_weighted_square(sparse(L), EigenRows(B.sparseView()), D);
  const MatrixXd exact = L + B * Eigen::Map<const Eigen::VectorXd>(D.data(), 6).asDiagonal() * B.transpose();
  EXPECT_LT((MatrixXd(eigen_of(sum)) - exact).norm(), 1e-14);
}

}  // namespace
}  // namespace tether
