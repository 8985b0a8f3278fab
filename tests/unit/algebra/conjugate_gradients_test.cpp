// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/krylov.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "unit/algebra/pressure_matrices.hpp"
#include "unit/alone.hpp"

namespace tether {
namespace {

using View = std::span<const double>;
using Room = std::span<double>;

void copy(View r, Room z) { std::copy(r.begin(), r.end(), z.begin()); }

KrylovResult solve_by_pcg(const SparseMatrix& A, const std::vector<double>& b, std::vector<double>& x, double tolerance,
                          int most) {
  return pcg(
      alone(), [&](View v, Room y) { A.multiply(v, y); }, copy, b, x, tolerance, most);
}

SparseMatrix diagonal(const std::vector<double>& entries) {
  Entries A(static_cast<std::int64_t>(entries.size()));
  for (std::size_t i = 0; i < entries.size(); ++i)
    A.add(static_cast<std::int64_t>(i), static_cast<std::int64_t>(i), entries[i]);
  return A.matrix();
}

SparseMatrix chain(int n, double end) {
  Entries A(n);
  for (int i = 1; i < n; ++i) A.add_bond(i - 1, i, 1);
  A.add(n - 1, n - 1, end);
  return A.matrix();
}

TEST(ConjugateGradients, TakesAsManyIterationsAsThereAreEigenvalues) {
  std::vector<double> entries(60, 2.0), x(60, 0.0);
  for (std::size_t i = 0; i < 20; ++i) entries[i] = 7, entries[20 + i] = 0.5;
  const KrylovResult result = solve_by_pcg(diagonal(entries), std::vector<double>(60, 1.0), x, 1e-13, 100);
  EXPECT_TRUE(result.converged);
  EXPECT_EQ(result.iterations, 3);
  for (std::size_t i = 0; i < 60; ++i) EXPECT_NEAR(x[i], 1 / entries[i], 1e-13);
}

TEST(ConjugateGradients, NeedsOneIterationWithTheInverse) {
  std::vector<double> entries(50), x(50, 3.0);
  for (std::size_t i = 0; i < 50; ++i) entries[i] = 1 + 1e3 * static_cast<double>(i);
  const SparseMatrix A = diagonal(entries);
  const auto result = pcg(
      alone(), [&](View v, Room y) { A.multiply(v, y); },
      [&](View r, Room z) {
        for (std::size_t i = 0; i < 50; ++i) z[i] = r[i] / entries[i];
      },
      std::vector<double>(50, 1.0), x, 1e-10, 100);
  EXPECT_TRUE(result.converged);
  EXPECT_EQ(result.iterations, 1);
}

/// |e_k|_A <= 2 ((sqrt(kappa) - 1) / (sqrt(kappa) + 1))^k |e_0|_A, for every k.
TEST(ConjugateGradients, ConvergesAtLeastAsFastAsTheConditionAllows) {
  constexpr int n = 100;
  Entries entries(n);
  for (int i = 1; i < n; ++i) entries.add_bond(i - 1, i, 1);
  entries.add(0, 0, 1), entries.add(n - 1, n - 1, 1);  // held at both ends: eigenvalues 4 sin^2(k pi / (2 n + 2))
  const SparseMatrix A = entries.matrix();
  const double root = 1 / std::tan(std::numbers::pi / (2 * n + 2)), rate = (root - 1) / (root + 1);
  std::vector<double> exact(n), b(n), e(n), Ae(n);
  for (std::size_t i = 0; i < n; ++i) exact[i] = std::cos(1.3 * static_cast<double>(i * i));
  A.multiply(exact, b);
  const double first = std::sqrt(dot(exact, b));
  for (int k = 1; k < 90; k += 4) {
    std::vector<double> x(n, 0.0);
    EXPECT_FALSE(solve_by_pcg(A, b, x, 1e-15, k).converged);
    for (std::size_t i = 0; i < n; ++i) e[i] = x[i] - exact[i];
    A.multiply(e, Ae);
    EXPECT_LE(std::sqrt(dot(e, Ae)), 2 * std::pow(rate, k) * first);
  }
  std::vector<double> x(n, 0.0);
  const KrylovResult all = solve_by_pcg(A, b, x, 1e-12, 200);
  EXPECT_TRUE(all.converged);
  EXPECT_LE(all.iterations, n + 1);
}

TEST(ConjugateGradients, StartsFromTheGuessAndStopsWhereTold) {
  const SparseMatrix A = chain(50, 1);
  std::vector<double> exact(50, 2.0), b(50), x = exact;
  A.multiply(exact, b);
  EXPECT_EQ(solve_by_pcg(A, b, x, 1e-12, 10).iterations, 0);
  EXPECT_EQ(x, exact);
  x.assign(50, 0.0);
  const KrylovResult cut = solve_by_pcg(A, b, x, 1e-12, 7);
  EXPECT_EQ(cut.iterations, 7);
  EXPECT_FALSE(cut.converged);
}

/// In doubles this residual cannot be: x is a million times b.
TEST(ConjugateGradients, EndsWhereRoundingDoes) {
  const SparseMatrix A = chain(2000, 1);
  std::vector<double> b(2000, 1.0), x(2000, 0.0), Ax(2000);
  const KrylovResult result = solve_by_pcg(A, b, x, 1e-15, 100000);
  EXPECT_TRUE(result.converged);
  EXPECT_LT(result.iterations, 20000);
  A.multiply(x, Ax);
  for (std::size_t i = 0; i < 2000; ++i) EXPECT_NEAR(Ax[i], 1, 1e-7);
}

TEST(ConjugateGradients, TakesZeroAndNoUnknowns) {
  std::vector<double> x(50, 2.0), none;
  const KrylovResult zero = solve_by_pcg(chain(50, 1), std::vector<double>(50, 0.0), x, 1e-12, 10);
  EXPECT_TRUE(zero.converged);
  EXPECT_EQ(zero.iterations, 0);
  EXPECT_EQ(x, std::vector<double>(50, 0.0));
  EXPECT_TRUE(solve_by_pcg({0, {0}, {}, {}}, none, none, 1e-12, 10).converged);
}

TEST(ConjugateGradients, SolvesASingularSystemThatHasASolution) {
  const SparseMatrix A = chain(40, 0);
  std::vector<double> b(40, 0.0), x(40, 0.0), Ax(40);
  b[3] = 1, b[30] = -1;
  ASSERT_TRUE(solve_by_pcg(A, b, x, 1e-12, 100).converged);
  A.multiply(x, Ax);
  for (std::size_t i = 0; i < 40; ++i) EXPECT_NEAR(Ax[i], b[i], 1e-11);
}

TEST(ConjugateGradients, SaysWhereAMatrixIsNotPositiveOrNoNumber) {
  std::vector<double> x(3, 0.0);
  EXPECT_FALSE(solve_by_pcg(diagonal({1, 1, -5}), {1, 1, 1}, x, 1e-12, 50).converged);
  x.assign(3, 0.0);
  EXPECT_FALSE(solve_by_pcg(diagonal({1, 1, 0}), {1, 1, 1}, x, 1e-12, 50).converged);
  x.assign(3, 0.0);
  EXPECT_FALSE(solve_by_pcg(diagonal({1, 2, std::nan("")}), {1, 1, 1}, x, 1e-12, 50).converged);
  x.assign(3, 0.0);
  EXPECT_FALSE(
      solve_by_pcg(diagonal({1, 2, 3}), {1, std::numeric_limits<double>::infinity(), 1}, x, 1e-12, 50).converged);
}

}  // namespace
}  // namespace tether
