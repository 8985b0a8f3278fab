// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/multigrid.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <limits>

#include "algebra/aggregates.hpp"
#include "algebra/krylov.hpp"
#include "unit/algebra/pressure_matrices.hpp"
#include "unit/algebra/support.hpp"
#include "unit/alone.hpp"

namespace tether {
namespace {

std::vector<double> chirp(std::int64_t n, double first = 0) {
  std::vector<double> x(static_cast<std::size_t>(n));
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = std::sin(first + 1.3 * static_cast<double>(i * i));
  return x;
}

KrylovResult solve_by_multigrid(AggregationMultigrid& multigrid, const SparseMatrix& A, const std::vector<double>& b,
                                std::vector<double>& x) {
  return pcg(
      alone(), [&](auto v, auto y) { A.multiply(v, y); }, [&](auto r, auto z) { multigrid.precondition(r, z); }, b, x,
      1e-10, 200);
}

/// Iterations for a known solution, which must be found.
int iterations(const SparseMatrix& A) {
  AggregationMultigrid multigrid(alone());
  EXPECT_TRUE(multigrid.set_up(A));
  const std::vector<double> exact = chirp(A.n);
  std::vector<double> b(exact.size()), x(exact.size(), 0.0);
  A.multiply(exact, b);
  const KrylovResult result = solve_by_multigrid(multigrid, A, b, x);
  EXPECT_TRUE(result.converged);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] -= exact[i];
  EXPECT_LT(norm(x), 1e-6 * norm(exact));
  return result.iterations;
}

TEST(Aggregates, HaveTheMatrixThatTheirSumsMake) {
  const SparseMatrix A = BodyMatrices({2, 16}).pressures(3);
  const SymmetricRows fine = rows_of(A);
  EXPECT_EQ(full_of(columns_of(fine)), full_of(A));
  SymmetricRows coarse;
  const Aggregates aggregates = aggregate(fine, coarse);
  Eigen::MatrixXd P = Eigen::MatrixXd::Zero(A.n, aggregates.count);
  for (std::int64_t i = 0; i < A.n; ++i) {
    const int I = aggregates.of[static_cast<std::size_t>(i)];
    if (I != Aggregates::alone) P(i, I) = 1;
  }
  EXPECT_LE(P.colwise().sum().maxCoeff(), 8);
  EXPECT_GE(P.colwise().sum().minCoeff(), 1);
  EXPECT_LT(aggregates.count, A.n / 5);
  const Eigen::MatrixXd exact = P.transpose() * full_of(A) * P;
  EXPECT_LT((full_of(columns_of(coarse)) - exact).norm(), 1e-13 * exact.norm());
}

TEST(Aggregates, MultiplyAsTheMatrixDoes) {
  const SparseMatrix A = BodyMatrices({3, 6}).pressures(3);
  std::vector<double> y(static_cast<std::size_t>(A.n)), z(y.size());
  A.multiply(chirp(A.n), y), rows_of(A).multiply(alone(), chirp(A.n), z);
  for (std::size_t i = 0; i < y.size(); ++i) EXPECT_NEAR(y[i], z[i], 1e-12);
}

TEST(Aggregates, HaveRowsOfASumOfMatrices) {
  const SparseMatrix A = BodyMatrices({2, 12}).pressures(3), some = BodyMatrices({2, 12}).pressures();
  Eigen::MatrixXd S = full_of(some);
  S.topRows(30).setZero(), S.leftCols(30).setZero(), S(2, 9) = S(9, 2) = 5;  // where A has nothing
  const SymmetricRows sum = rows_of_sum(A, EigenSparse(S.sparseView()));
  EXPECT_EQ(full_of(columns_of(sum)), full_of(A) + S);
}

TEST(Aggregates, FollowStrongCouplingsAndLeaveDominatedRowsAlone) {
  Entries A(8);  // strong between 2 k and 2 k + 1, weak elsewhere; the last two have next to no couplings
  for (int i = 1; i < 7; ++i) A.add_bond(i - 1, i, i % 2 == 1 && i < 6 ? 1 : 1e-3);
  A.add(0, 0, 1e-3), A.add(6, 6, 1), A.add(7, 7, 1);
  SymmetricRows coarse;
  const Aggregates aggregates = aggregate(rows_of(A.matrix()), coarse);
  for (std::size_t i = 0; i < 6; i += 2) EXPECT_EQ(aggregates.of[i], aggregates.of[i + 1]);
  EXPECT_EQ(aggregates.of[6], Aggregates::alone);
  EXPECT_EQ(aggregates.of[7], Aggregates::alone);
}

/// As for the exact inverse: a number of iterations that does not grow with the box, where one of a V-cycle, or of an
/// incomplete factorisation, would double from box to box.
TEST(AggregationMultigrid, TakesAsManyIterationsInAFineBoxAsInACoarseOne) {
  for (const double ratio : {1.0, 100.0}) {
    const int coarse = iterations(BodyMatrices({2, 32, 0, true, ratio}).pressures());
    const int fine = iterations(BodyMatrices({2, 128, 0, true, ratio}).pressures());
    EXPECT_LE(coarse, 35);
    EXPECT_LE(fine, 1.4 * coarse);
  }
  const int coarse = iterations(BodyMatrices({3, 16}).pressures()),
            fine = iterations(BodyMatrices({3, 32}).pressures());
  EXPECT_LE(coarse, 35);
  EXPECT_LE(fine, 1.2 * coarse);
}

TEST(AggregationMultigrid, TakesDenserRowsOfABody) {
  const BodyMatrices body({3, 16, 0.01, true, 1});
  const int bare = iterations(body.pressures());
  for (const double added : {0.1, 1.0, 10.0}) EXPECT_LE(iterations(body.pressures(added)), bare + 8);
}

TEST(AggregationMultigrid, IsSymmetricAndPositiveOnTwoLevels) {
  const SparseMatrix A = BodyMatrices({2, 40}).pressures(1);
  AggregationMultigrid multigrid(alone());
  ASSERT_TRUE(multigrid.set_up(A));
  ASSERT_EQ(multigrid.levels(), 2);
  const std::vector<double> r = chirp(A.n), s = chirp(A.n, 2);
  std::vector<double> Pr(r.size()), Ps(r.size());
  multigrid.precondition(r, Pr), multigrid.precondition(s, Ps);
  EXPECT_NEAR(dot(s, Pr), dot(r, Ps), 1e-12 * norm(s) * norm(Pr));
  EXPECT_GT(dot(r, Pr), 0);
}

TEST(AggregationMultigrid, IsTheInverseOfASmallMatrix) {
  EXPECT_LE(iterations(BodyMatrices({2, 20}).pressures()), 2);
  EXPECT_LE(iterations(BodyMatrices({3, 7}).pressures(2)), 2);
}

TEST(AggregationMultigrid, CostsLittleMoreThanTheMatrix) {
  AggregationMultigrid multigrid(alone());
  ASSERT_TRUE(multigrid.set_up(BodyMatrices({3, 24}).pressures()));
  EXPECT_GE(multigrid.levels(), 3);
  EXPECT_LT(multigrid.complexity(), 1.5);
}

/// A box without an outlet; and many of eight cells, whose aggregates have diagonals of 0 or of what rounding leaves,
/// beside one of 8000.
TEST(AggregationMultigrid, TakesPocketsWithoutAnOutlet) {
  constexpr int small = 320, all = small + 8000;
  Entries entries(all);
  for (int i = 1; i < all; ++i) {
    if (i > small || (i < small && i % 8 > 0)) entries.add_bond(i - 1, i, i < 150 ? 1 : 1.0 / (3 + i % 17));
  }
  const SparseMatrix box = BodyMatrices({2, 64, 0, false}).pressures(), pockets = entries.matrix();
  for (const SparseMatrix& A : {box, pockets}) {
    AggregationMultigrid multigrid(alone());
    ASSERT_TRUE(multigrid.set_up(A));
    std::vector<double> b(static_cast<std::size_t>(A.n)), x(b.size(), 0.0);
    A.multiply(chirp(A.n), b);
    const KrylovResult result = solve_by_multigrid(multigrid, A, b, x);
    EXPECT_TRUE(result.converged);
    EXPECT_LE(result.iterations, 60);
    for (const double value : x) EXPECT_LT(std::abs(value), 1e6);
  }
}

TEST(AggregationMultigrid, TakesRowsWithoutCouplingsAndNoRows) {
  Entries diagonal(3000);
  for (int i = 0; i < 3000; ++i) diagonal.add(i, i, 1 + i % 7);
  EXPECT_EQ(iterations(diagonal.matrix()), 1);
  AggregationMultigrid multigrid(alone());
  ASSERT_TRUE(multigrid.set_up(SparseMatrix{0, {0}, {}, {}}));
  multigrid.precondition({}, {});
}

TEST(AggregationMultigrid, SaysWhereADiagonalIsNotPositive) {
  AggregationMultigrid multigrid(alone());
  for (const double bad :
       {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    SparseMatrix A = BodyMatrices({2, 32}).pressures();
    A.value.back() = bad;
    EXPECT_FALSE(multigrid.set_up(A));
  }
  EXPECT_FALSE(multigrid.set_up(Entries(3).matrix()));
  ASSERT_TRUE(multigrid.set_up(BodyMatrices({2, 32}).pressures()));
}

TEST(AggregationMultigrid, IsTheSameFromRunToRun) {
  const SparseMatrix A = BodyMatrices({3, 16}).pressures(1);
  const std::vector<double> b = chirp(A.n);
  std::vector<double> x(b.size(), 0.0), y(b.size(), 0.0);
  AggregationMultigrid one(alone()), other(alone());
  ASSERT_TRUE(other.set_up(BodyMatrices({2, 40}).pressures()));  // what was before leaves no trace
  ASSERT_TRUE(one.set_up(A) && other.set_up(A));
  solve_by_multigrid(one, A, b, x), solve_by_multigrid(other, A, b, y);
  EXPECT_EQ(x, y);
}

}  // namespace
}  // namespace tether
