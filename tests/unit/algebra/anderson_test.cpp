// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/anderson.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace tether {
namespace {

using Vector = Eigen::VectorXd;

/// The largest entry of f after so many guesses from 0.
double left_after(int guesses, const std::function<Vector(const Vector&)>& f, double bent) {
  constexpr Eigen::Index n = 8;
  AndersonMixing mixing(std::vector<double>(n, 1.0), 40, bent);
  std::vector<double> x(n, 0.0);
  Vector left;
  for (int k = 0; k <= guesses; ++k) {
    left = f(Eigen::Map<const Vector>(x.data(), n));
    if (k < guesses) mixing.next({left.data(), n}, x);
  }
  return left.cwiseAbs().maxCoeff();
}

/// b - A x with eigenvalues from 0.2 to 1.6: guesses that go on by f alone gain a fifth each.
Vector linear(const Vector& x) {
  Vector f(x.size());
  for (Eigen::Index k = 0; k < x.size(); ++k) f[k] = 1 - 0.2 * static_cast<double>(k + 1) * x[k];
  return f;
}

/// The same with a part that is not linear.
Vector bent_a_little(const Vector& x) {
  Vector f = linear(x);
  for (Eigen::Index k = 0; k < x.size(); ++k) f[k] += 3e-3 * x.squaredNorm() * std::sin(3.0 * static_cast<double>(k));
  return f;
}

TEST(AndersonMixing, FindsWhereALinearFunctionIsZeroInAsManyGuessesAsItHasEigenvalues) {
  EXPECT_LT(left_after(9, linear, 0), 1e-9);
  EXPECT_GT(left_after(6, linear, 0), 1e-6);
}

TEST(AndersonMixing, FindsItWhereTheFunctionIsNotQuiteLinear) {
  EXPECT_LT(left_after(25, bent_a_little, 3e-3), 1e-6);
  EXPECT_LT(left_after(25, linear, 3e-3), 1e-6);
}

/// Two changes of f that differ by a five-hundredth: what is left along their difference would be sought with a hundred
/// times both.
TEST(AndersonMixing, DoesNotTrustChangesThatCancel) {
  const auto length_of_step = [](double bent) {
    AndersonMixing mixing({1, 1}, 40, bent);
    std::vector<double> x{0, 0};
    mixing.next(std::vector<double>{1, 0.099}, x);
    x = {1, 0};
    mixing.next(std::vector<double>{0.5, 0.099}, x);
    x = {1, 1};
    mixing.next(std::vector<double>{0, 0.1}, x);
    return std::hypot(x[0] - 1, x[1] - 1);
  };
  EXPECT_GT(length_of_step(0), 100);
  EXPECT_LT(length_of_step(3e-3), 30);
}

}  // namespace
}  // namespace tether
