// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/sparse_solver.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

#include "unit/algebra/support.hpp"

namespace tether {
namespace {

/// A chain of bars of four nodes each, two unknowns a node.
struct Chain {
  std::vector<int> nodes;
  NodalPattern pattern;
  explicit Chain(int elements)
      : nodes(all(elements)), pattern(2, static_cast<std::size_t>(3 * elements + 1), nodes, 4) {}
  static std::vector<int> all(int elements) {
    std::vector<int> nodes;
    for (int e = 0; e < elements; ++e) {
      for (int a = 0; a < 4; ++a) nodes.push_back(3 * e + a);
    }
    return nodes;
  }
};

using Matrix8 = Eigen::Matrix<double, 8, 8, Eigen::RowMajor>;

/// Assembled element by element into a sparse matrix and, the slow way, into a full one.
struct Assembled {
  SparseMatrix sparse;
  Eigen::MatrixXd full;
};

Assembled assembled(const Chain& chain, int elements, bool symmetric) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1, 1);
  Assembled A{chain.pattern.matrix(), Eigen::MatrixXd::Zero(6 * elements + 2, 6 * elements + 2)};
  for (int e = 0; e < elements; ++e) {
    Matrix8 k = Matrix8::NullaryExpr([&] { return number(random); });
    if (symmetric) k = (k * k.transpose() + Matrix8::Identity()).eval();
    chain.pattern.add(static_cast<std::size_t>(e), {k.data(), 64}, A.sparse);
    A.full.block<8, 8>(6 * e, 6 * e) += k;
  }
  return A;
}

double error_of_solution(const Assembled& A, Definite definite, const std::string& method, int block = 1) {
  SparseSolver solver(block);
  EXPECT_TRUE(solver.factorise(A.sparse, definite));
  EXPECT_EQ(solver.method(), method);
  EXPECT_GT(solver.factor_nonzeros(), 0);
  const Eigen::VectorXd exact = Eigen::VectorXd::LinSpaced(A.full.rows(), -1, 2), b = A.full * exact;
  Eigen::VectorXd x(b.size());
  solver.solve({b.data(), static_cast<std::size_t>(b.size())}, {x.data(), static_cast<std::size_t>(x.size())});
  return (x - exact).norm() / exact.norm();
}

TEST(SparseMatrix, HasWhatIsAssembled) {
  const auto A = assembled(Chain(5), 5, false);
  EXPECT_EQ((full_of(A.sparse) - A.full).norm(), 0);
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(A.full.rows(), 1, 3);
  Eigen::VectorXd y(x.size());
  A.sparse.multiply({x.data(), static_cast<std::size_t>(x.size())}, {y.data(), static_cast<std::size_t>(y.size())});
  EXPECT_LT((y - A.full * x).norm(), 1e-13);
}

TEST(SparseMatrix, HeldUnknownsStandAlone) {
  auto A = assembled(Chain(3), 3, true);
  std::vector<std::uint8_t> held(static_cast<std::size_t>(A.sparse.n), 0);
  held[4] = 1;
  hold(A.sparse, held, 3.5);
  A.full.row(4).setZero(), A.full.col(4).setZero(), A.full(4, 4) = 3.5;
  EXPECT_EQ((full_of(A.sparse) - A.full).norm(), 0);
}

TEST(SparseSolver, SolvesSymmetricAndOtherMatrices) {
  EXPECT_LT(error_of_solution(assembled(Chain(40), 40, true), Definite::positive, "cholesky"), 1e-12);
  EXPECT_LT(error_of_solution(assembled(Chain(40), 40, true), Definite::general, "lu"), 1e-12);
  EXPECT_LT(error_of_solution(assembled(Chain(40), 40, false), Definite::general, "lu"), 1e-10);
}

TEST(SparseSolver, OrdersNodesForTheirUnknowns) {
  EXPECT_LT(error_of_solution(assembled(Chain(40), 40, true), Definite::positive, "cholesky", 2), 1e-12);
  EXPECT_LT(error_of_solution(assembled(Chain(40), 40, false), Definite::general, "lu", 2), 1e-10);
}

TEST(SparseSolver, TakesTheGeneralWayWhereAMatrixIsNotPositive) {
  auto A = assembled(Chain(6), 6, true);
  for (double& value : A.sparse.value) value = -value;
  A.full = -A.full;
  EXPECT_LT(error_of_solution(A, Definite::positive, "lu"), 1e-12);
}

TEST(SparseSolver, AnalysesAPatternOnce) {
  SparseSolver solver;
  const auto A = assembled(Chain(6), 6, true), B = assembled(Chain(9), 9, true);
  ASSERT_TRUE(solver.factorise(A.sparse, Definite::positive));
  const double once = solver.analysis().wall;
  ASSERT_TRUE(solver.factorise(A.sparse, Definite::positive));
  EXPECT_EQ(solver.analysis().wall, once);
  ASSERT_TRUE(solver.factorise(B.sparse, Definite::positive));
  EXPECT_GT(solver.analysis().wall, once);
}

TEST(SparseSolver, SaysWhereAMatrixIsSingular) {
  auto A = assembled(Chain(4), 4, true);
  std::vector<std::uint8_t> held(static_cast<std::size_t>(A.sparse.n), 0);
  held[3] = 1;
  hold(A.sparse, held, 0);
  SparseSolver solver;
  EXPECT_FALSE(solver.factorise(A.sparse, Definite::positive));
}

}  // namespace
}  // namespace tether
