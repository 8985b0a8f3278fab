// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/krylov.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <limits>
#include <random>

namespace tether {
namespace {

using Vector = Eigen::VectorXd;

std::span<double> span_of(Vector& v) { return {v.data(), static_cast<std::size_t>(v.size())}; }
auto view(std::span<const double> v) { return Eigen::Map<const Vector>(v.data(), static_cast<Eigen::Index>(v.size())); }
auto view(std::span<double> v) { return Eigen::Map<Vector>(v.data(), static_cast<Eigen::Index>(v.size())); }

Eigen::MatrixXd random_matrix(Eigen::Index n) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> number(-1, 1);
  return Eigen::MatrixXd::NullaryExpr(n, n, [&] { return number(random); });
}

/// Solves A x = b with the preconditioner P, whose inverse is given.
KrylovResult solve_by_gmres(const Eigen::MatrixXd& A, const Eigen::MatrixXd& inverse, Vector b, Vector& x, int restart,
                            int most = 500) {
  return gmres([&](std::span<const double> v, std::span<double> y) { view(y) = A * view(v); },
               [&](std::span<const double> r, std::span<double> z) { view(z) = inverse * view(r); }, span_of(b),
               span_of(x), 1e-12, restart, most);
}

TEST(Gmres, SolvesInAsManyIterationsAsThereAreUnknowns) {
  constexpr Eigen::Index n = 30;
  const Eigen::MatrixXd A = random_matrix(n), one = Eigen::MatrixXd::Identity(n, n);
  const Vector exact = Vector::LinSpaced(n, -1, 2);
  Vector x = Vector::Zero(n);
  const auto result = solve_by_gmres(A, one, A * exact, x, 60);
  EXPECT_TRUE(result.converged);
  EXPECT_EQ(result.iterations, n);
  EXPECT_LT((x - exact).norm(), 1e-10);
}

TEST(Gmres, TakesAsManyIterationsAsThereAreEigenvalues) {
  Vector eigenvalues = Vector::Constant(40, 2);
  eigenvalues.tail(5).setConstant(-3), eigenvalues.tail(1).setConstant(100);
  const Eigen::MatrixXd Q = Eigen::HouseholderQR<Eigen::MatrixXd>(random_matrix(40)).householderQ();
  const Eigen::MatrixXd A = Q * eigenvalues.asDiagonal() * Q.transpose(), one = Eigen::MatrixXd::Identity(40, 40);
  Vector x = Vector::Zero(40);
  EXPECT_EQ(solve_by_gmres(A, one, Vector::Ones(40), x, 60).iterations, 3);
  EXPECT_LT((A * x - Vector::Ones(40)).norm(), 1e-10);
}

TEST(Gmres, BeginsAnewAndStartsFromTheGuess) {
  constexpr Eigen::Index n = 50;
  const Eigen::MatrixXd A = random_matrix(n) + 8 * Eigen::MatrixXd::Identity(n, n),
                        one = Eigen::MatrixXd::Identity(n, n);
  const Vector exact = Vector::LinSpaced(n, 1, 3);
  Vector x = Vector::Zero(n);
  const auto restarted = solve_by_gmres(A, one, A * exact, x, 7);
  EXPECT_TRUE(restarted.converged);
  EXPECT_GT(restarted.iterations, 14);
  EXPECT_LT((x - exact).norm(), 1e-10);
  EXPECT_EQ(solve_by_gmres(A, one, A * exact, x, 7).iterations, 0);
}

TEST(Gmres, NeedsOneIterationWithTheInverse) {
  const Eigen::MatrixXd A = random_matrix(20);
  Vector x = Vector::Zero(20);
  const auto result = solve_by_gmres(A, A.inverse(), Vector::Ones(20), x, 5);
  EXPECT_TRUE(result.converged);
  EXPECT_LE(result.iterations, 2);
}

TEST(Gmres, OfNothingMakesNothing) {
  const Eigen::MatrixXd A = random_matrix(20);
  Vector x = Vector::Ones(20);
  EXPECT_EQ(solve_by_gmres(A, A.inverse(), Vector::Zero(20), x, 5).iterations, 0);
  EXPECT_EQ(x.norm(), 0);
}

TEST(Gmres, SaysWhereItDoesNotConverge) {
  Eigen::MatrixXd A = random_matrix(20), one = Eigen::MatrixXd::Identity(20, 20);
  A.row(3).setZero();
  Vector x = Vector::Zero(20);
  const auto result = solve_by_gmres(A, one, Vector::Ones(20), x, 60, 45);
  EXPECT_FALSE(result.converged);
  EXPECT_LE(result.iterations, 45);
  Vector bad = Vector::Ones(20);
  for (const double value : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    bad[2] = value;
    EXPECT_FALSE(solve_by_gmres(A, one, bad, x, 60).converged) << value;
  }
}

/// A matrix whose powers soon point one way: without a second pass the vectors lose their right angles.
TEST(KrylovBasis, StaysOrthonormalWhereVectorsAreNearlyParallel) {
  constexpr Eigen::Index n = 25;
  const Vector diagonal = Vector::NullaryExpr(n, [](Eigen::Index i) { return std::pow(10, -0.6 * i); });
  KrylovBasis basis(n, 20);
  Vector w = Vector::Ones(n);
  basis.start(span_of(w));
  Eigen::MatrixXd V(n, 21);
  for (int k = 0; k < 20; ++k) {
    V.col(k) = view(basis.last());
    w = diagonal.cwiseProduct(V.col(k));
    basis.add(span_of(w));
  }
  V.col(20) = view(basis.last());
  EXPECT_LT((V.transpose() * V - Eigen::MatrixXd::Identity(21, 21)).norm(), 1e-13);
}

}  // namespace
}  // namespace tether
