// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/small_factors.hpp"

#include <gtest/gtest.h>
#include <vector>

namespace tether {
namespace {

/// The second differences of a row of places, and `more` on the diagonal.
Eigen::SparseMatrix<double> differences(int count, double more) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int k = 0; k < count; ++k) {
    entries.emplace_back(k, k, 2 + more);
    if (k > 0) entries.emplace_back(k, k - 1, -1.0);
    if (k > 0) entries.emplace_back(k - 1, k, -1.0);
  }
  Eigen::SparseMatrix<double> A(count, count);
  A.setFromTriplets(entries.begin(), entries.end());
  return A;
}

/// -u'' = 1 with u = 0 at both ends is u = k (n + 1 - k) / 2, by second differences, too.
TEST(SmallFactors, AParabolaIsFoundToRounding) {
  constexpr int count = 30;
  SmallFactors factors;
  ASSERT_TRUE(factors.factorise(differences(count, 0)));
  Eigen::VectorXd u(count);
  factors.solve(Eigen::VectorXd(Eigen::VectorXd::Ones(count)), u);
  for (int k = 1; k <= count; ++k) EXPECT_NEAR(u[k - 1], 0.5 * k * (count + 1 - k), 1e-11);
}

TEST(SmallFactors, ColumnsAreSolvedEachForItself) {
  const Eigen::SparseMatrix<double> A = differences(12, 0.5);
  const Eigen::MatrixXd b = Eigen::MatrixXd::Random(12, 3);
  SmallFactors factors;
  ASSERT_TRUE(factors.factorise(A));
  const Eigen::MatrixXd x = factors.solve(b);
  EXPECT_LT((A * x - b).norm(), 1e-13 * b.norm());
  Eigen::VectorXd one(12);
  factors.solve(Eigen::VectorXd(b.col(1)), one);
  EXPECT_EQ((one - x.col(1)).norm(), 0);
}

TEST(SmallFactors, APivotOf0IsReported) {
  SmallFactors factors;
  EXPECT_FALSE(factors.factorise(differences(1, -2)));
}

}  // namespace
}  // namespace tether
