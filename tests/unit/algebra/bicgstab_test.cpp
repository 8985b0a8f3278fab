// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/krylov.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "unit/algebra/pressure_matrices.hpp"
#include "unit/algebra/support.hpp"

namespace tether {
namespace {

/// Convection and diffusion, upwind, on cells x cells, held at 0 all around: not symmetric.
SparseMatrix convection(int cells, double peclet) {
  Entries A(cells * cells);
  for (int i = 0; i < cells * cells; ++i) {
    A.add(i, i, 4 + 2 * peclet);
    if (i % cells > 0) A.add(i, i - 1, -1 - peclet);
    if (i % cells + 1 < cells) A.add(i, i + 1, -1);
    if (i >= cells) A.add(i, i - cells, -1 - peclet);
    if (i + cells < cells * cells) A.add(i, i + cells, -1);
  }
  return A.matrix();
}

struct Outcome {
  KrylovResult result;
  double error, residual;
  std::vector<double> x;
};

Outcome solved(const SparseMatrix& A, double tolerance, int most, const IncompleteLu& factors = {}) {
  const std::vector<double> exact = waves(A.n);
  std::vector<double> b(exact.size()), Ax(exact.size()), x(exact.size(), 0.0);
  A.multiply(exact, b);
  Outcome outcome{bicgstab(A, b, x, tolerance, most, factors), 0, 0, x};
  A.multiply(x, Ax);
  for (std::size_t i = 0; i < x.size(); ++i) Ax[i] -= b[i], x[i] -= exact[i];
  outcome.error = norm(x) / norm(exact), outcome.residual = norm(Ax) / norm(b);
  return outcome;
}

TEST(Bicgstab, SolvesMatricesThatAreNotSymmetric) {
  for (const double peclet : {0.0, 1.0, 100.0}) {
    const Outcome outcome = solved(convection(40, peclet), 1e-11, 200);
    EXPECT_TRUE(outcome.result.converged);
    EXPECT_LE(outcome.residual, 1.001e-11);
    EXPECT_LT(outcome.error, 1e-8);
  }
}

TEST(Bicgstab, SolvesForFluidAndSolidWithSignsThatMakeThemPositive) {
  const BodyMatrices body({2, 32, 0, true, 1});
  SparseMatrix K = body.coupled(1, 10);
  for (std::size_t k = 0; k < K.row.size(); ++k) {
    if (K.row[k] >= body.velocities()) K.value[k] = -K.value[k];  // [A, -B^T; B, L]
  }
  const Outcome outcome = solved(K, 1e-10, 300);
  EXPECT_TRUE(outcome.result.converged);
  EXPECT_LT(outcome.error, 1e-7);
}

TEST(Bicgstab, NeedsFewIterationsWithFactorsOfMuch) {
  const SparseMatrix A = convection(40, 3);
  const int complete = solved(A, 1e-11, 200, {0, 1000}).result.iterations;
  const int some = solved(A, 1e-11, 200, {1e-2, 10}).result.iterations;
  const int little = solved(A, 1e-11, 200, {1e-2, 1}).result.iterations;
  EXPECT_LE(complete, 1);
  EXPECT_LT(complete, some);
  EXPECT_LT(some, little);
}

TEST(Bicgstab, StopsWhereToldAndStartsFromTheGuess) {
  const SparseMatrix A = convection(40, 0);
  const Outcome cut = solved(A, 1e-12, 3, {1e-1, 1});
  EXPECT_FALSE(cut.result.converged);
  EXPECT_LE(cut.result.iterations, 3);
  std::vector<double> x = waves(A.n), b(x.size());
  const std::vector<double> exact = x;
  A.multiply(exact, b);
  EXPECT_EQ(bicgstab(A, b, x, 1e-12, 50).iterations, 0);
  EXPECT_EQ(x, exact);
}

TEST(Bicgstab, TakesZeroAndNoUnknowns) {
  std::vector<double> x(100, 2.0), none;
  EXPECT_TRUE(bicgstab(convection(10, 1), std::vector<double>(100, 0.0), x, 1e-12, 10).converged);
  EXPECT_EQ(x, std::vector<double>(100, 0.0));
  EXPECT_TRUE(bicgstab({0, {0}, {}, {}}, none, none, 1e-12, 10).converged);
}

TEST(Bicgstab, SaysWhereThereIsNoSolution) {
  SparseMatrix singular = convection(10, 1), bad = convection(10, 1);
  std::vector<std::uint8_t> held(100, 0);
  held[50] = 1;
  hold(singular, held, 0);
  bad.value[7] = std::numeric_limits<double>::quiet_NaN();
  for (const SparseMatrix& A : {singular, bad, Entries(100).matrix()}) {
    std::vector<double> x(100, 0.0);
    EXPECT_FALSE(bicgstab(A, std::vector<double>(100, 1.0), x, 1e-10, 100).converged);
  }
}

TEST(Bicgstab, IsTheSameFromRunToRun) {
  const SparseMatrix A = convection(40, 3);
  EXPECT_EQ(solved(A, 1e-11, 200, {1e-2, 4}).x, solved(A, 1e-11, 200, {1e-2, 4}).x);
}

}  // namespace
}  // namespace tether
