// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/quasidefinite_solver.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <limits>

#include "algebra/krylov.hpp"
#include "unit/algebra/pressure_matrices.hpp"
#include "unit/algebra/support.hpp"

namespace tether {
namespace {

/// Of the solution of K x = b for a known x, over |x|.
double error_of(QuasidefiniteSolver& solver, const SparseMatrix& K) {
  const std::vector<double> exact = waves(K.n);
  std::vector<double> x(exact.size());
  K.multiply(exact, x);
  solver.solve(x, x);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] -= exact[i];
  return norm(x) / norm(exact);
}

SparseMatrix lower_of(const SparseMatrix& K) {
  SparseMatrix lower{K.n, {0}, {}, {}};
  for (std::int64_t j = 0; j < K.n; ++j) {
    for (auto at = K.start[static_cast<std::size_t>(j)]; at < K.start[static_cast<std::size_t>(j) + 1]; ++at) {
      const auto k = static_cast<std::size_t>(at);
      if (K.row[k] >= j) lower.row.push_back(K.row[k]), lower.value.push_back(K.value[k]);
    }
    lower.start.push_back(static_cast<std::int64_t>(lower.row.size()));
  }
  return lower;
}

TEST(QuasidefiniteSolver, SolvesForFluidAndSolidAndCountsTheCells) {
  for (const BodyInBox box : {BodyInBox{2, 24}, BodyInBox{3, 10}}) {
    const BodyMatrices body(box);
    const SparseMatrix K = body.coupled(1, 50);
    QuasidefiniteSolver solver;
    ASSERT_TRUE(solver.factorise(K));
    EXPECT_EQ(solver.negative_pivots(), body.cells());
    EXPECT_GT(solver.factor_nonzeros(), K.n);
    EXPECT_LT(error_of(solver, K), 1e-11);
  }
}

TEST(QuasidefiniteSolver, CountsTheNegativeEigenvalues) {
  const SparseMatrix K = BodyMatrices({2, 8}).coupled(2, 3);
  Eigen::MatrixXd full = Eigen::MatrixXd::Zero(K.n, K.n);
  for (std::int64_t j = 0; j < K.n; ++j) {
    for (auto at = K.start[static_cast<std::size_t>(j)]; at < K.start[static_cast<std::size_t>(j) + 1]; ++at)
      full(K.row[static_cast<std::size_t>(at)], j) = K.value[static_cast<std::size_t>(at)];
  }
  const Eigen::VectorXd eigenvalues = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(full).eigenvalues();
  QuasidefiniteSolver solver;
  ASSERT_TRUE(solver.factorise(K));
  EXPECT_EQ(solver.negative_pivots(), (eigenvalues.array() < 0).count());
}

TEST(QuasidefiniteSolver, ReadsTheLowerTriangleAlone) {
  const SparseMatrix K = BodyMatrices({2, 12}).coupled(1, 5), lower = lower_of(K);
  QuasidefiniteSolver by_full, by_lower;
  ASSERT_TRUE(by_full.factorise(K) && by_lower.factorise(lower));
  const std::vector<double> b = waves(K.n);
  std::vector<double> x(b.size()), y(b.size());
  by_full.solve(b, x), by_lower.solve(b, y);
  EXPECT_EQ(x, y);
  ASSERT_TRUE(by_full.factorise(lower));  // no other pattern, then
  EXPECT_EQ(by_full.analyses(), 1);
}

TEST(QuasidefiniteSolver, KeepsTheOrderWhileTheBodyMovesALittle) {
  QuasidefiniteSolver solver;
  ASSERT_TRUE(solver.factorise(BodyMatrices({2, 48}).coupled(1, 50)));
  ASSERT_TRUE(solver.factorise(BodyMatrices({2, 48}).coupled(2, 40)));
  EXPECT_EQ(solver.analyses(), 1);
  const BodyMatrices moved({2, 48, 0.3 / 48});
  ASSERT_TRUE(solver.factorise(moved.coupled(1, 50)));
  EXPECT_EQ(solver.analyses(), 2);
  EXPECT_EQ(solver.orders(), 1);
  EXPECT_EQ(solver.negative_pivots(), moved.cells());
  EXPECT_LT(error_of(solver, moved.coupled(1, 50)), 1e-11);
}

TEST(QuasidefiniteSolver, FindsANewOrderWhereTheOldOneFillsTheFactor) {
  Entries chain(576);
  for (int i = 0; i < 576; ++i) chain.add(i, i, 3);
  for (int i = 1; i < 576; ++i) chain.add_both(i, i - 1, -1);
  const SparseMatrix grid = BodyMatrices({2, 24}).pressures();
  QuasidefiniteSolver solver, fresh;
  ASSERT_TRUE(solver.factorise(chain.matrix()));
  EXPECT_EQ(solver.factor_nonzeros(), 576 + 575);
  ASSERT_TRUE(solver.factorise(grid) && fresh.factorise(grid));
  EXPECT_EQ(solver.orders(), 2);
  EXPECT_EQ(solver.factor_nonzeros(), fresh.factor_nonzeros());
  EXPECT_LT(error_of(solver, grid), 1e-11);
  ASSERT_TRUE(solver.factorise(BodyMatrices({2, 23}).pressures()));  // another size
  EXPECT_EQ(solver.orders(), 3);
}

TEST(QuasidefiniteSolver, RefinesWhatSmallPivotsSpoil) {
  Entries pairs(20);
  for (int i = 0; i < 20; i += 2) pairs.add(i, i, 1e-8), pairs.add(i + 1, i + 1, -1e-8), pairs.add_both(i, i + 1, 1);
  const SparseMatrix K = pairs.matrix();
  QuasidefiniteSolver solver;
  ASSERT_TRUE(solver.factorise(K));
  EXPECT_EQ(solver.negative_pivots(), 10);
  EXPECT_LT(error_of(solver, K), 1e-14);
}

TEST(QuasidefiniteSolver, TakesNoUnknownsAndRowsOfMinusIdentity) {
  QuasidefiniteSolver solver;
  ASSERT_TRUE(solver.factorise({0, {0}, {}, {}}));
  EXPECT_EQ(solver.negative_pivots(), 0);
  EXPECT_EQ(solver.factor_nonzeros(), 0);
  solver.solve({}, {});
  Entries diagonal(5);
  for (int i = 0; i < 5; ++i) diagonal.add(i, i, -1);
  ASSERT_TRUE(solver.factorise(diagonal.matrix()));
  EXPECT_EQ(solver.negative_pivots(), 5);
  EXPECT_EQ(error_of(solver, diagonal.matrix()), 0);
  ASSERT_TRUE(solver.factorise({0, {0}, {}, {}}));
  ASSERT_TRUE(solver.factorise(diagonal.matrix()));
  EXPECT_EQ(error_of(solver, diagonal.matrix()), 0);
}

TEST(QuasidefiniteSolver, SaysWhereAPivotIsZeroOrNoNumber) {
  QuasidefiniteSolver solver;
  Entries empty_row(3), zero(2);
  empty_row.add(0, 0, 1), empty_row.add(2, 2, -1);
  zero.add(0, 0, 0.0), zero.add(1, 1, 1);
  EXPECT_FALSE(solver.factorise(empty_row.matrix()));
  EXPECT_FALSE(solver.factorise(zero.matrix()));
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    SparseMatrix K = BodyMatrices({2, 8}).pressures(), L = K;
    K.value[1] = L.value.back() = bad;  // below the diagonal, on it
    EXPECT_FALSE(solver.factorise(K));
    EXPECT_FALSE(solver.factorise(L));
  }
  const SparseMatrix good = BodyMatrices({2, 8}).pressures();
  ASSERT_TRUE(solver.factorise(good));
  EXPECT_LT(error_of(solver, good), 1e-12);
}

TEST(QuasidefiniteSolver, IsTheSameFromRunToRun) {
  const SparseMatrix K = BodyMatrices({3, 8}).coupled(1, 50);
  std::vector<double> x(static_cast<std::size_t>(K.n)), y(x.size());
  QuasidefiniteSolver one, other;
  ASSERT_TRUE(one.factorise(K) && other.factorise(K));
  one.solve(waves(K.n), x), other.solve(waves(K.n), y);
  EXPECT_EQ(x, y);
}

}  // namespace
}  // namespace tether
