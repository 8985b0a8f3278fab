// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/bicgstab.hpp"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <cmath>

namespace tether {
namespace {

using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor, std::int64_t>;
using Vector = Eigen::VectorXd;
using Solver = Eigen::BiCGSTAB<Matrix, Eigen::IncompleteLUT<double, std::int64_t>>;

}  // namespace

KrylovResult bicgstab(const SparseMatrix& A, std::span<const double> b, std::span<double> x, double tolerance, int most,
                      const IncompleteLu& factors) {
  KrylovResult result;
  const double enough = tolerance * norm(b);
  if (enough == 0) std::fill(x.begin(), x.end(), 0.0);
  const Matrix matrix = Eigen::Map<const Matrix>(A.n, A.n, static_cast<Eigen::Index>(A.row.size()), A.start.data(),
                                                 A.row.data(), A.value.data());
  const Eigen::Map<const Vector> right(b.data(), A.n);
  Eigen::Map<Vector> solution(x.data(), A.n);
  Solver solver;
  solver.preconditioner().setDroptol(factors.drop);
  solver.preconditioner().setFillfactor(factors.fill);
  solver.setTolerance(tolerance);
  int done = 1;
  while (true) {
    const double residual = (right - matrix * solution).norm();
    const bool finite = residual < 1e300;
    result.converged = finite && residual <= enough;
    if (result.converged || !finite || done == 0 || result.iterations >= most) return result;
    if (result.iterations == 0) solver.compute(matrix);
    if (solver.preconditioner().info() != Eigen::Success) return result;
    solver.setMaxIterations(most - result.iterations);
    solution = solver.solveWithGuess(right, solution).eval();
    done = static_cast<int>(solver.iterations());
    result.iterations += done;
  }
}

}  // namespace tether
