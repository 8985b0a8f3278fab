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

TEST(SparseProducts, CongruentIsThatOfDenseMatrices) {
  const MatrixXd S = numbers(5, 5), E = numbers(5, 3);
  const EigenSparse of_sparse = congruent(EigenSparse(S.sparseView()), EigenSparse(E.sparseView()));
  EXPECT_LT((MatrixXd(of_sparse) - E.transpose() * S * E).norm(), 1e-15);
}

TEST(SparseProducts, WeightedSquareIsThatOfDenseMatrices) {
  const MatrixXd B = numbers(4, 6);
  const std::vector<double> D{1, 2, 0.5, 4, 8, 3};
  const EigenSparse square = weighted_square(EigenRows(B.sparseView()), D);
  const MatrixXd exact = B * Eigen::Map<const Eigen::VectorXd>(D.data(), 6).asDiagonal() * B.transpose();
  EXPECT_LT((MatrixXd(square) - exact).norm(), 1e-14);
}

}  // namespace
}  // namespace tether
