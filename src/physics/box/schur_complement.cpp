// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/schur_complement.hpp"

#include <algorithm>
#include <exception>
#include <utility>

#include "algebra/dense.hpp"
#include "algebra/krylov.hpp"
#include "algebra/sparse_products.hpp"
#include "base/diagnostics.hpp"
#include "base/numbers.hpp"

namespace tether::coupled {

ConstantPressures::ConstantPressures(const CoupledEquations& equations) {
  std::vector<int> number;
  int count = 0;
  for (std::size_t r = 0; r < equations.closed.size(); ++r)
    number.push_back(equations.closed[r] != 0 && equations.loose[r] == 0 ? count++ : -1);
  for (const int region : equations.region) of_.push_back(number[at(region)]);
  cells_.assign(at(count), 0.0);
  add_sums(std::vector<double>(of_.size(), 1.0), cells_);
}

void ConstantPressures::add_sums(std::span<const double> x, std::span<double> sums) const {
  for (std::size_t k = 0; k < of_.size(); ++k) {
    if (of_[k] >= 0) sums[at(of_[k])] += x[k];
  }
}

void ConstantPressures::add(std::span<const double> c, std::span<double> p) const {
  for (std::size_t k = 0; k < of_.size(); ++k) {
    if (of_[k] >= 0) p[k] += c[at(of_[k])];
  }
}

std::vector<double> ConstantPressures::take_means(std::span<double> p) const {
  std::vector<double> means(count(), 0.0), back;
  add_sums(p, means);
  for (std::size_t c = 0; c < means.size(); ++c) means[c] /= cells_[c], back.push_back(-means[c]);
  add(back, p);
  return means;
}

RegionConstants::RegionConstants(const CoupledEquations& equations, const ReducedEquations& with)
    : constants_(equations),
      border_(constants_.count(), std::vector<double>(with.b.size() + equations.cells, 0.0)),
      right_(constants_.count(), 0.0) {
  constants_.add_sums(with.r, right_);
  for (std::size_t p = 0; p < with.r.size(); ++p) {
    if (constants_.of(p) < 0) continue;
    auto& border = border_[at(constants_.of(p))];
    for (CouplingMatrix::InnerIterator entry(equations.B, static_cast<std::int64_t>(p)); entry; ++entry) {
      const auto column = static_cast<std::size_t>(entry.col());
      if (equations.held[column] == 0) border[column] -= entry.value();
    }
  }
}

std::vector<double> RegionConstants::found(QuasidefiniteSolver& factors, std::span<double> x) const {
  const auto count = static_cast<Eigen::Index>(border_.size());
  if (count == 0) return {};
  std::vector<std::vector<double>> solved(border_);
  for (auto& column : solved) factors.solve(column, column);
  Eigen::MatrixXd schur(count, count);
  Eigen::VectorXd right(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto& border = border_[static_cast<std::size_t>(i)];
    for (Eigen::Index j = 0; j < count; ++j) schur(i, j) = tether::dot(border, solved[static_cast<std::size_t>(j)]);
    right[i] = tether::dot(border, x) - right_[static_cast<std::size_t>(i)];
  }
  const Eigen::VectorXd c = solve_symmetric(schur, right);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto& column = solved[static_cast<std::size_t>(i)];
    for (std::size_t k = 0; k < column.size(); ++k) x[k] -= column[k] * c[i];
  }
  return {c.begin(), c.end()};
}

namespace {

constexpr int most_iterations = 2000;

/// A map with the columns of held velocities and the rows of pinned pressures empty.
CouplingMatrix free_part(CouplingMatrix B, const CoupledEquations& of, std::span<const std::uint8_t> pinned) {
  B.prune([&](std::int64_t row, std::int64_t column, double) {
    return pinned[static_cast<std::size_t>(row)] == 0 && of.held[static_cast<std::size_t>(column)] == 0;
  });
  return B;
}

}  // namespace

/// The order of elimination is the whole A's: what contact holds of it changes. The solids' factors and multigrid know
/// nothing of each other.
bool SchurComplement::set_up(const CoupledEquations& equations, std::span<const std::uint8_t> pinned) {
  if (std::exchange(ordered_, equations.A.n) != equations.A.n) solids_.order_by(equations.A);
  SparseMatrix A = held_matrix(equations.A, equations.held);
  std::vector<double> inverse;  // of A's diagonal
  for (std::int64_t k = 0; k < A.n; ++k) inverse.push_back(1 / std::abs(diagonal(A, k)));
  preconditioner_.clear();  // what another solution had left makes room before anything is made
  B_ = free_part(equations.B, equations, pinned), flux_ = {};
  if (&equations.flux != &equations.B) flux_ = free_part(equations.flux, equations, pinned);
  forces_.resize(equations.b.size()), moved_.resize(equations.b.size());
  bool has_factors = true, has_levels = true;
  std::exception_ptr failure;
  team_.each(0, 2, [&](std::size_t part) {
    try {
      if (part == 0)
        has_factors = A.n == 0 || solids_.factorise(std::exchange(A, {}), equations.definite);
      else
        has_levels = make_levels(equations, inverse);
    } catch (...) {
      failure = std::current_exception();
    }
  });
  if (failure) std::rethrow_exception(failure);
  if (!has_factors && equations.definite == Definite::positive) throw RunError("the solids' matrix is singular");
  if (!has_factors) return false;
  constants_ = ConstantPressures(equations);
  set_up_constants();
  return has_levels && preconditioner_.factorise();
}

/// Makes the levels of L + B D^-1 B^T, of which `inverse` has D^-1: D is the diagonal of A. It is not to find
/// constants: one pressure of each closed region is tied down for it.
bool SchurComplement::make_levels(const CoupledEquations& equations, std::span<const double> inverse) {
  SymmetricRows nearby = rows_of_sum(*L_, weighted_square(B_, inverse));
  const std::vector<std::uint8_t> first = first_pressures(equations, equations.closed);
  for (std::size_t k = 0; k < first.size(); ++k) {
    if (first[k] != 0) nearby.scale[k] = nearby.diagonal[k] += diagonal(*L_, static_cast<std::int64_t>(k));
  }
  return preconditioner_.make_levels(std::move(nearby), equations.coarse);
}

/// L, with what is pinned held.
void SchurComplement::take_pressures(const CoupledEquations& equations, std::span<const std::uint8_t> pinned) {
  const bool any = std::find(pinned.begin(), pinned.end(), 1) != pinned.end();
  if (any && !equations.same_matrices) held_L_ = held_matrix(equations.L, pinned);
  L_ = any ? &held_L_ : &equations.L;
}

/// Column by column of what the solids yield to constants. Two of these may drive the solids alike.
void SchurComplement::set_up_constants() {
  const auto count = static_cast<Eigen::Index>(constants_.count());
  stiffness_.resize(count, count);
  if (count == 0) return;
  Eigen::VectorXd x(L_->n + count), y(L_->n + count);
  const auto size = static_cast<std::size_t>(x.size());
  for (Eigen::Index c = 0; c < count; ++c) {
    x.setZero();
    x[L_->n + c] = 1;
    multiply({x.data(), size}, {y.data(), size});
    stiffness_.col(c) = y.tail(count);
  }
  stiffness_ = pseudo_inverse(stiffness_);
}

/// A^-1 of forces.
void SchurComplement::move_solids(std::span<const double> forces) {
  if (!forces.empty()) solids_.solve(forces, moved_);
}

/// Multiplies [x; c].
void SchurComplement::multiply(std::span<const double> x, std::span<double> y) {
  const auto n = static_cast<std::size_t>(L_->n);
  whole_.assign(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(n));
  constants_.add(x.subspan(n), whole_);
  std::fill(forces_.begin(), forces_.end(), 0.0);
  add_transposed_product(B_, 1, whole_, forces_);
  move_solids(forces_);
  std::fill(whole_.begin(), whole_.end(), 0.0), std::fill(y.begin(), y.end(), 0.0);
  add_product(flux(), 1, moved_, whole_);
  constants_.add_sums(whole_, y.subspan(n));
  multiply_symmetric(team_, *L_, x.first(n), y.first(n));
  for (std::size_t k = 0; k < n; ++k) y[k] += whole_[k];
}

/// x is without means, which c has.
void SchurComplement::precondition(std::span<const double> r, std::span<double> z) {
  const auto n = static_cast<std::size_t>(L_->n);
  const auto count = stiffness_.rows();
  whole_.assign(r.begin(), r.begin() + static_cast<std::ptrdiff_t>(n));
  constants_.take_means(whole_);
  preconditioner_.precondition(whole_, z.first(n));
  constants_.take_means(z.first(n));
  Eigen::Map<Eigen::VectorXd>(z.data() + n, count) =
      stiffness_ * Eigen::Map<const Eigen::VectorXd>(r.data() + n, count);
}

KrylovResult SchurComplement::iterate(bool symmetric, std::span<const double> right, double tolerance,
                                      std::span<double> x) {
  constexpr int restart = 60;
  const auto by = [&](std::span<const double> v, std::span<double> y) { multiply(v, y); };
  const auto with = [&](std::span<const double> r, std::span<double> z) { precondition(r, z); };
  return symmetric ? pcg(team_, by, with, right, x, tolerance, most_iterations)
                   : gmres(by, with, right, x, tolerance, restart, most_iterations);
}

KrylovResult SchurComplement::solve(const CoupledEquations& equations, const ReducedEquations& with, double tolerance,
                                    std::span<double> u, std::span<double> p) {
  take_pressures(equations, with.pinned);
  if (!equations.same_matrices && !set_up(equations, with.pinned)) return {0, false};
  const std::size_t n = p.size();
  for (std::size_t k = 0; k < n; ++k) p[k] = with.pinned[k] != 0 ? 0 : p[k];
  std::vector<double> x(p.begin(), p.end());
  const std::vector<double> means = constants_.take_means(x);
  x.insert(x.end(), means.begin(), means.end());
  std::vector<double> right(x.size(), 0.0);
  move_solids(with.b);
  for (std::size_t k = 0; k < n; ++k) right[k] = -with.r[k];
  add_product(flux(), -1, moved_, std::span(right).first(n));
  constants_.add_sums(std::span(right).first(n), std::span(right).subspan(n));
  const KrylovResult result = iterate(equations.definite == Definite::positive, right, tolerance, x);
  std::copy_n(x.begin(), n, p.begin());
  constants_.add(std::span(x).subspan(n), p);
  forces_ = with.b;
  add_transposed_product(B_, 1, p, forces_);
  move_solids(forces_);
  std::copy(moved_.begin(), moved_.end(), u.begin());
  return result;
}

bool SchurComplement::set_up_pressures(const CoupledEquations& equations) {
  return preconditioner_.make_levels(rows_of(*L_), equations.coarse) && preconditioner_.factorise();
}

KrylovResult SchurComplement::solve_pressures(const CoupledEquations& equations, std::span<const std::uint8_t> pinned,
                                              std::span<const double> right, double tolerance, std::span<double> p) {
  take_pressures(equations, pinned);
  if (!equations.same_matrices && !set_up_pressures(equations)) return {0, false};
  return pcg(
      team_, [&](std::span<const double> x, std::span<double> y) { multiply_symmetric(team_, *L_, x, y); },
      [&](std::span<const double> r, std::span<double> z) { preconditioner_.precondition(r, z); }, right, p, tolerance,
      most_iterations);
}

}  // namespace tether::coupled
