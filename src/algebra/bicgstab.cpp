// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/bicgstab.hpp"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>

namespace tether {
namespace {

using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor, std::int64_t>;
using Vector = Eigen::VectorXd;
using Solver = Eigen::BiCGSTAB<Matrix, Eigen::IncompleteLUT<double, std::int64_t>>;

/// Fewer iterations than these are not looked at; of more, the residual must have fallen to this share.
constexpr int between_looks = 200;
constexpr double enough_progress = 0.1;

}  // namespace

/// Where the recurrence has broken down, or ended short of the residual itself, it begins anew from the best x.
KrylovResult bicgstab(const SparseMatrix& A, std::span<const double> b, std::span<double> x, double tolerance, int most,
                      const IncompleteLu& factors) {
  KrylovResult result;
  const double enough = tolerance * norm(b);
  if (enough == 0) std::fill(x.begin(), x.end(), 0.0);
  const Matrix matrix = Eigen::Map<const Matrix>(A.n, A.n, static_cast<Eigen::Index>(A.row.size()), A.start.data(),
                                                 A.row.data(), A.value.data());
  const Eigen::Map<const Vector> right(b.data(), A.n);
  Eigen::Map<Vector> solution(x.data(), A.n);
  Vector best = Vector::Zero(A.n);
  double least = right.norm();
  Solver solver;
  solver.preconditioner().setDroptol(factors.drop);
  solver.preconditioner().setFillfactor(factors.fill);
  solver.setTolerance(tolerance);
  for (bool first = true;; first = false) {
    const double residual = (right - matrix * solution).norm(), before = least;
    if (residual < least) least = residual, best = solution;
    solution = best;
    result.converged = least <= enough;
    if (result.converged || result.iterations >= most || !std::isfinite(least)) return result;
    if (!first && least > enough_progress * before) return result;
    if (first) solver.compute(matrix);
    if (solver.preconditioner().info() != Eigen::Success) return result;
    solver.setMaxIterations(std::min(between_looks, most - result.iterations));
    solution = solver.solveWithGuess(right, best).eval();
    result.iterations += static_cast<int>(solver.iterations());
  }
}

}  // namespace tether
