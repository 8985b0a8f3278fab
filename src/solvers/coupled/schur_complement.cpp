// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/coupled/schur_complement.hpp"

#include <utility>

#include "algebra/conjugate_gradients.hpp"
#include "base/errors.hpp"
#include "base/index.hpp"

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
  forces_.resize(equations.b.size()), moved_.resize(equations.b.size());
  constants_ = ConstantPressures(equations);
  set_up_constants();
  return multigrid_.set_up(nearby(pinned_once(), A, B_));
}

/// L less the freedom of constants, which multigrid is not to find: one pressure of each of their regions is tied down.
SparseMatrix SchurComplement::pinned_once() const {
  SparseMatrix L = L_;
  std::vector<std::uint8_t> done(constants_.count(), 0);
  for (std::size_t k = 0; k < static_cast<std::size_t>(L.n); ++k) {
    if (constants_.of(k) < 0 || std::exchange(done[at(constants_.of(k))], 1) != 0) continue;
    for (auto e = static_cast<std::size_t>(L.start[k]); e < static_cast<std::size_t>(L.start[k + 1]); ++e) {
      if (L.row[e] == static_cast<std::int64_t>(k)) L.value[e] *= 2;
    }
  }
  return L;
}

/// Column by column. Two constants may drive the solids alike.
void SchurComplement::set_up_constants() {
  const std::size_t count = constants_.count();
  stiffness_.resize(static_cast<Eigen::Index>(count), static_cast<Eigen::Index>(count));
  if (count == 0) return;
  for (std::size_t c = 0; c < count; ++c) {
    std::vector<double> unit(count, 0.0), flux(static_cast<std::size_t>(L_.n), 0.0), sums(count, 0.0);
    unit[c] = 1;
    constants_.add(unit, flux);
    move_solids(flux);
    std::fill(flux.begin(), flux.end(), 0.0);
    add_product(B_, 1, moved_, flux);
    constants_.add_sums(flux, sums);
    stiffness_.col(static_cast<Eigen::Index>(c)) = Eigen::Map<const Eigen::VectorXd>(sums.data(), stiffness_.rows());
  }
  stiffness_ = stiffness_.completeOrthogonalDecomposition().pseudoInverse().eval();
}

/// A^-1 B^T p.
void SchurComplement::move_solids(std::span<const double> p) {
  std::fill(forces_.begin(), forces_.end(), 0.0);
  add_transposed_product(B_, 1, p, forces_);
  if (!forces_.empty()) solids_.solve(forces_, moved_);
}

/// Of [x; c].
void SchurComplement::multiply(std::span<const double> x, std::span<double> y) {
  const auto n = static_cast<std::size_t>(L_.n);
  whole_.assign(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(n));
  constants_.add(x.subspan(n), whole_);
  move_solids(whole_);
  std::fill(whole_.begin(), whole_.end(), 0.0), std::fill(y.begin(), y.end(), 0.0);
  add_product(B_, 1, moved_, whole_);
  constants_.add_sums(whole_, y.subspan(n));
  L_.multiply(x.first(n), y.first(n));
  for (std::size_t k = 0; k < n; ++k) y[k] += whole_[k];
}

/// x is without means, which c has.
void SchurComplement::precondition(std::span<const double> r, std::span<double> z) {
  const auto n = static_cast<std::size_t>(L_.n);
  const auto count = stiffness_.rows();
  whole_.assign(r.begin(), r.begin() + static_cast<std::ptrdiff_t>(n));
  constants_.take_means(whole_);
  multigrid_.precondition(whole_, z.first(n));
  constants_.take_means(z.first(n));
  Eigen::Map<Eigen::VectorXd>(z.data() + n, count) =
      stiffness_ * Eigen::Map<const Eigen::VectorXd>(r.data() + n, count);
}

KrylovResult SchurComplement::solve(const CoupledEquations& equations, const ReducedEquations& with, double tolerance,
                                    std::span<double> u, std::span<double> p) {
  if (!equations.same_matrices && !set_up(equations, with.pinned)) return {0, false};
  const std::size_t n = p.size();
  for (std::size_t k = 0; k < n; ++k) p[k] = with.pinned[k] != 0 ? 0 : p[k];
  std::vector<double> x(p.begin(), p.end());
  const std::vector<double> means = constants_.take_means(x);
  x.insert(x.end(), means.begin(), means.end());
  std::vector<double> right(x.size(), 0.0);
  if (!forces_.empty()) solids_.solve(with.b, moved_);
  for (std::size_t k = 0; k < n; ++k) right[k] = -with.r[k];
  add_product(B_, -1, moved_, std::span(right).first(n));
  constants_.add_sums(std::span(right).first(n), std::span(right).subspan(n));
  const KrylovResult result = pcg([&](std::span<const double> v, std::span<double> y) { multiply(v, y); },
                                  [&](std::span<const double> r, std::span<double> z) { precondition(r, z); }, right, x,
                                  tolerance, most_iterations);
  std::copy_n(x.begin(), n, p.begin());
  constants_.add(std::span(x).subspan(n), p);
  forces_ = with.b;
  add_transposed_product(B_, 1, p, forces_);
  if (!forces_.empty()) solids_.solve(forces_, moved_);
  std::copy(moved_.begin(), moved_.end(), u.begin());
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
