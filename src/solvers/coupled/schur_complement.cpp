// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/coupled/schur_complement.hpp"

#include <utility>

#include "algebra/conjugate_gradients.hpp"
#include "base/errors.hpp"

namespace tether::coupled {
namespace {

constexpr int most_iterations = 2000;

using ByColumns = Eigen::SparseMatrix<double, Eigen::ColMajor, std::int64_t>;
using Square = Eigen::Map<const ByColumns>;

Square view(const SparseMatrix& A) {
  return {A.n, A.n, static_cast<std::int64_t>(A.value.size()), A.start.data(), A.row.data(), A.value.data()};
}

SparseMatrix plain(const ByColumns& A) {
  SparseMatrix out;
  out.n = A.cols();
  out.start.assign(A.outerIndexPtr(), A.outerIndexPtr() + A.cols() + 1);
  out.row.assign(A.innerIndexPtr(), A.innerIndexPtr() + A.nonZeros());
  out.value.assign(A.valuePtr(), A.valuePtr() + A.nonZeros());
  return out;
}

/// B with the columns of held velocities and the rows of pinned pressures empty.
CouplingMatrix free_part(const CoupledEquations& of, std::span<const std::uint8_t> pinned) {
  CouplingMatrix B = of.B;
  B.prune([&](std::int64_t row, std::int64_t column, double) {
    return pinned[static_cast<std::size_t>(row)] == 0 && of.held[static_cast<std::size_t>(column)] == 0;
  });
  return B;
}

/// L + B D^-1 B^T, D the diagonal of A.
SparseMatrix nearby(const SparseMatrix& L, const SparseMatrix& A, const CouplingMatrix& B) {
  Eigen::VectorXd inverse(A.n);
  for (std::int64_t k = 0; k < A.n; ++k) inverse[k] = 1 / diagonal(A, k);
  const ByColumns shifted = view(L) + ByColumns(B * inverse.asDiagonal() * B.transpose());
  return plain(shifted);
}

}  // namespace

/// The order of elimination is the whole A's: what contact holds of it changes.
bool SchurComplement::set_up(const CoupledEquations& equations, std::span<const std::uint8_t> pinned) {
  if (std::exchange(ordered_, equations.A.n) != equations.A.n) solids_.order_by(equations.A);
  const SparseMatrix A = held_matrix(equations.A, equations.held);
  if (A.n > 0 && !solids_.factorise(A, Definite::positive)) throw RunError("the solids' matrix is singular");
  B_ = free_part(equations, pinned), L_ = held_matrix(equations.L, pinned);
  return multigrid_.set_up(nearby(L_, A, B_));
}

KrylovResult SchurComplement::solve(const CoupledEquations& equations, const ReducedEquations& with, double tolerance,
                                    std::span<double> u, std::span<double> p) {
  if (!equations.same_matrices && !set_up(equations, with.pinned)) return {0, false};
  std::vector<double> forces(with.b), moved(with.b.size()), right(p.size());
  const auto solve_solids = [&] {
    if (!forces.empty()) solids_.solve(forces, moved);
  };
  solve_solids();
  for (std::size_t k = 0; k < right.size(); ++k) right[k] = -with.r[k];
  add_product(B_, -1, moved, right);
  const auto multiply = [&](std::span<const double> x, std::span<double> y) {
    L_.multiply(x, y);
    std::fill(forces.begin(), forces.end(), 0.0);
    add_transposed_product(B_, 1, x, forces);
    solve_solids();
    add_product(B_, 1, moved, y);
  };
  for (std::size_t k = 0; k < p.size(); ++k) p[k] = with.pinned[k] != 0 ? 0 : p[k];
  const KrylovResult result = pcg(
      multiply, [&](std::span<const double> r, std::span<double> z) { multigrid_.precondition(r, z); }, right, p,
      tolerance, most_iterations);
  forces = with.b;
  add_transposed_product(B_, 1, p, forces);
  solve_solids();
  std::copy(moved.begin(), moved.end(), u.begin());
  return result;
}

KrylovResult SchurComplement::solve_pressures(const CoupledEquations& equations, std::span<const std::uint8_t> pinned,
                                              std::span<const double> right, double tolerance, std::span<double> p) {
  if (!equations.same_matrices) {
    L_ = held_matrix(equations.L, pinned);
    if (!multigrid_.set_up(L_)) return {0, false};
  }
  return pcg([&](std::span<const double> x, std::span<double> y) { L_.multiply(x, y); },
             [&](std::span<const double> r, std::span<double> z) { multigrid_.precondition(r, z); }, right, p,
             tolerance, most_iterations);
}

}  // namespace tether::coupled
