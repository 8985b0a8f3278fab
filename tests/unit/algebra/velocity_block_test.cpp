// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/saddle_solver.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

namespace tether {
namespace {

/// Numbers where `has` says so, on the diagonal `diagonal` more.
template <class Has>
Eigen::MatrixXd filled(Eigen::Index n, double diagonal, const Has& has) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> number(-1, 1);
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) A(i, j) = has(i, j) ? number(random) + (i == j ? diagonal : 0) : 0;
  }
  return A;
}

template <class Has>
SparseMatrix sparse_of(const Eigen::MatrixXd& A, const Has& has) {
  SparseMatrix sparse{A.rows(), {0}, {}, {}};
  for (Eigen::Index j = 0; j < A.rows(); ++j) {
    for (Eigen::Index i = 0; i < A.rows(); ++i)
      if (has(i, j)) sparse.row.push_back(i), sparse.value.push_back(A(i, j));
    sparse.start.push_back(static_cast<std::int64_t>(sparse.row.size()));
  }
  return sparse;
}

constexpr auto narrow = [](Eigen::Index i, Eigen::Index j) { return std::abs(i / 2 - j / 2) < 2; };
constexpr auto grid = [](Eigen::Index i, Eigen::Index j) { return std::abs(i - j) < 2 || std::abs(i - j) == 6; };

/// Nodes of two unknowns each.
std::vector<int> nodes_of(int unknowns) {
  std::vector<int> first;
  for (int i = 0; i <= unknowns; i += 2) first.push_back(i);
  return first;
}

Eigen::VectorXd solved(VelocityBlock& block, const Eigen::VectorXd& r) {
  Eigen::VectorXd u(r.size());
  block.solve({r.data(), static_cast<std::size_t>(r.size())}, {u.data(), static_cast<std::size_t>(u.size())});
  return u;
}

TEST(PrincipalBlock, HasTheRowsAndColumnsKept) {
  const Eigen::MatrixXd A = filled(12, 0, grid);
  const std::vector<std::int64_t> kept{0, 1, 4, 6, 7, 11};
  const SparseMatrix block = principal_block(sparse_of(A, grid), kept);
  ASSERT_EQ(block.n, 6);
  Eigen::MatrixXd full = Eigen::MatrixXd::Zero(6, 6), expected(6, 6);
  for (std::size_t j = 0; j < 6; ++j) {
    for (auto k = static_cast<std::size_t>(block.start[j]); k < static_cast<std::size_t>(block.start[j + 1]); ++k)
      full(block.row[k], static_cast<Eigen::Index>(j)) = block.value[k];
    for (std::size_t i = 0; i < 6; ++i)
      expected(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = A(kept[i], kept[j]);
  }
  EXPECT_EQ((full - expected).norm(), 0);
}

/// In a band nothing is left out, so that the incomplete factors are complete.
TEST(VelocityBlock, SolvesExactlyWhereFactorsFillNothing) {
  const Eigen::MatrixXd A = filled(40, 4, narrow);
  const Eigen::VectorXd exact = Eigen::VectorXd::LinSpaced(40, -1, 1);
  for (const auto method : {VelocityMethod::complete, VelocityMethod::incomplete}) {
    VelocityBlock block(method, nodes_of(40));
    ASSERT_TRUE(block.factorise(sparse_of(A, narrow)));
    EXPECT_LT((solved(block, A * exact) - exact).norm(), 1e-13);
    EXPECT_GE(block.factor_nonzeros(), 40);
  }
}

/// L and U of the pattern of A whose product is A there, from a full matrix.
Eigen::MatrixXd incomplete_product(Eigen::MatrixXd A) {
  const Eigen::Index n = A.rows();
  for (Eigen::Index k = 0; k < n; ++k) {
    for (Eigen::Index i = k + 1; i < n; ++i) {
      if (!grid(i, k)) continue;
      A(i, k) /= A(k, k);
      for (Eigen::Index j = k + 1; j < n; ++j)
        if (grid(i, j)) A(i, j) -= A(i, k) * A(k, j);
    }
  }
  const Eigen::MatrixXd L = A.triangularView<Eigen::UnitLower>(), U = A.triangularView<Eigen::Upper>();
  return L * U;
}

TEST(VelocityBlock, HasTheIncompleteFactorsOfItsPattern) {
  const Eigen::MatrixXd A = filled(36, 4, grid), product = incomplete_product(A);
  ASSERT_GT((product - A).norm(), 0.1);
  VelocityBlock block(VelocityMethod::incomplete, nodes_of(36));
  ASSERT_TRUE(block.factorise(sparse_of(A, grid)));
  const Eigen::VectorXd exact = Eigen::VectorXd::LinSpaced(36, -1, 1);
  EXPECT_LT((solved(block, product * exact) - exact).norm(), 1e-13);
}

TEST(VelocityBlock, SaysWhereAMatrixIsSingular) {
  Eigen::MatrixXd A = filled(12, 4, narrow);
  A.row(5).setZero();
  for (const auto method : {VelocityMethod::complete, VelocityMethod::incomplete}) {
    VelocityBlock block(method, nodes_of(12));
    EXPECT_FALSE(block.factorise(sparse_of(A, narrow)));
    A.row(5).setZero(), A(5, 5) = 1;
    EXPECT_TRUE(block.factorise(sparse_of(A, narrow)));
    A(5, 5) = 0;
  }
}

}  // namespace
}  // namespace tether
