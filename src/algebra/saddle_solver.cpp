// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/saddle_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "algebra/krylov.hpp"

namespace tether {
namespace {

constexpr std::size_t absent = static_cast<std::size_t>(-1);

}  // namespace

SparseMatrix principal_block(const SparseMatrix& A, std::span<const std::int64_t> kept) {
  std::vector<std::int64_t> place(static_cast<std::size_t>(A.n), -1);
  for (std::size_t k = 0; k < kept.size(); ++k) place[static_cast<std::size_t>(kept[k])] = static_cast<std::int64_t>(k);
  SparseMatrix block;
  block.n = static_cast<std::int64_t>(kept.size());
  block.start.push_back(0);
  for (const std::int64_t column : kept) {
    const auto j = static_cast<std::size_t>(column);
    for (auto k = static_cast<std::size_t>(A.start[j]); k < static_cast<std::size_t>(A.start[j + 1]); ++k) {
      const std::int64_t row = place[static_cast<std::size_t>(A.row[k])];
      if (row >= 0) block.row.push_back(row), block.value.push_back(A.value[k]);
    }
    block.start.push_back(static_cast<std::int64_t>(block.row.size()));
  }
  return block;
}

VelocityBlock::VelocityBlock(VelocityMethod method, std::vector<int> first)
    : method_(method), solver_(std::move(first)) {}

bool VelocityBlock::factorise(SparseMatrix A) {
  A_ = std::move(A);
  return method_ == VelocityMethod::complete ? solver_.factorise(A_, Definite::general) : factorise_in_place();
}

/// A_ becomes L and U without what stands outside of its pattern, ILU(0). Column by column, so that those before are
/// ready: U's part by them, then L's by the pivot.
bool VelocityBlock::factorise_in_place() {
  const auto n = static_cast<std::size_t>(A_.n);
  auto& value = A_.value;
  diagonal_.resize(n);
  std::vector<std::size_t> place(n, absent);  // of each row in the column
  for (std::size_t j = 0; j < n; ++j) {
    const auto first = static_cast<std::size_t>(A_.start[j]), end = static_cast<std::size_t>(A_.start[j + 1]);
    for (std::size_t k = first; k < end; ++k) place[static_cast<std::size_t>(A_.row[k])] = k;
    if (place[j] == absent) return false;
    diagonal_[j] = place[j];
    for (std::size_t k = first; k < diagonal_[j]; ++k) {
      const auto i = static_cast<std::size_t>(A_.row[k]);
      for (std::size_t l = diagonal_[i] + 1; l < static_cast<std::size_t>(A_.start[i + 1]); ++l) {
        const std::size_t to = place[static_cast<std::size_t>(A_.row[l])];
        if (to != absent) value[to] -= value[l] * value[k];
      }
    }
    const double pivot = value[diagonal_[j]];
    if (pivot == 0 || !std::isfinite(pivot)) return false;
    for (std::size_t k = diagonal_[j] + 1; k < end; ++k) value[k] /= pivot;
    for (std::size_t k = first; k < end; ++k) place[static_cast<std::size_t>(A_.row[k])] = absent;
  }
  return true;
}

void VelocityBlock::solve(std::span<const double> r, std::span<double> u) {
  method_ == VelocityMethod::complete ? solver_.solve(r, u) : solve_in_place(r, u);
}

void VelocityBlock::solve_in_place(std::span<const double> r, std::span<double> u) const {
  std::copy(r.begin(), r.end(), u.begin());
  const std::size_t n = u.size();
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t k = diagonal_[j] + 1; k < static_cast<std::size_t>(A_.start[j + 1]); ++k)
      u[static_cast<std::size_t>(A_.row[k])] -= A_.value[k] * u[j];
  }
  for (std::size_t j = n; j-- > 0;) {
    u[j] /= A_.value[diagonal_[j]];
    for (auto k = static_cast<std::size_t>(A_.start[j]); k < diagonal_[j]; ++k)
      u[static_cast<std::size_t>(A_.row[k])] -= A_.value[k] * u[j];
  }
}

double VelocityBlock::factor_nonzeros() const {
  return method_ == VelocityMethod::complete ? solver_.factor_nonzeros() : static_cast<double>(A_.value.size());
}

namespace {

constexpr int restart = 60, least_patience = 30, most_iterations = 200;

/// a A + c C, whose patterns may differ.
SparseMatrix sum_of(double a, const SparseMatrix& A, double c, const SparseMatrix& C) {
  SparseMatrix sum;
  sum.n = A.n;
  sum.start.push_back(0);
  for (std::size_t j = 0; j < static_cast<std::size_t>(A.n); ++j) {
    auto k = static_cast<std::size_t>(A.start[j]), l = static_cast<std::size_t>(C.start[j]);
    const auto k_end = static_cast<std::size_t>(A.start[j + 1]), l_end = static_cast<std::size_t>(C.start[j + 1]);
    while (k < k_end || l < l_end) {
      const std::int64_t row_a = k < k_end ? A.row[k] : A.n, row_c = l < l_end ? C.row[l] : A.n;
      double value = 0;
      if (row_a <= row_c) value += a * A.value[k++];
      if (row_c <= row_a) value += c * C.value[l++];
      sum.row.push_back(std::min(row_a, row_c)), sum.value.push_back(value);
    }
    sum.start.push_back(static_cast<std::int64_t>(sum.row.size()));
  }
  return sum;
}

std::vector<std::int64_t> unknowns_that(std::uint8_t are_pressures, const std::vector<std::uint8_t>& is_pressure) {
  std::vector<std::int64_t> unknowns;
  for (std::size_t i = 0; i < is_pressure.size(); ++i)
    if (is_pressure[i] == are_pressures) unknowns.push_back(static_cast<std::int64_t>(i));
  return unknowns;
}

/// The nodes' first unknowns among the velocities.
std::vector<int> first_velocities(const SaddleUnknowns& unknowns) {
  std::vector<int> first{0};
  for (std::size_t node = 0; node + 1 < unknowns.first.size(); ++node) {
    const auto from = unknowns.is_pressure.begin() + unknowns.first[node];
    const auto to = unknowns.is_pressure.begin() + unknowns.first[node + 1];
    first.push_back(first.back() + static_cast<int>(std::count(from, to, 0)));
  }
  return first;
}

}  // namespace

SaddleSolver::SaddleSolver(const SaddleUnknowns& unknowns, SparseMatrix Mp, SparseMatrix Lp, VelocityMethod method)
    : closed_(unknowns.closed),
      velocities_(unknowns_that(0, unknowns.is_pressure)),
      pressures_(unknowns_that(1, unknowns.is_pressure)),
      Mp_(std::move(Mp)),
      Lp_(std::move(Lp)),
      velocity_(method, first_velocities(unknowns)),
      ru_(velocities_.size()),
      u_(velocities_.size()),
      rp_(pressures_.size()),
      p_(pressures_.size()),
      q_(pressures_.size()) {}

void SaddleSolver::scales(double viscous, double inertial) {
  pressure_factorised_ = pressure_factorised_ && viscous == viscous_ && inertial == inertial_;
  viscous_ = viscous, inertial_ = inertial;
}

bool SaddleSolver::renew(const SparseMatrix& K) {
  renewed_ = true;
  factorised_ = velocity_.factorise(principal_block(K, velocities_)) && renew_pressure(K);
  return factorised_;
}

/// The two terms of S^, with the sign of S taken off. Anew only where something of them has changed.
bool SaddleSolver::renew_pressure(const SparseMatrix& K) {
  SparseMatrix C = principal_block(K, pressures_);
  if (pressure_factorised_ && C.value == C_.value && C.row == C_.row) return true;
  C_ = std::move(C);
  const double sign = viscous_ < 0 || inertial_ < 0 ? -1 : 1;
  if (viscous_ != 0) viscous_part_ = sum_of(sign / viscous_, Mp_, sign, C_);
  if (inertial_ != 0) inertial_part_ = sum_of(sign / inertial_, Lp_, sign, C_);
  pressure_factorised_ = (viscous_ == 0 || mass_.factorise(viscous_part_, Definite::positive)) &&
                         (inertial_ == 0 || laplacian_.factorise(inertial_part_, Definite::positive));
  find_constant(K);
  return pressure_factorised_;
}

/// Finds what S has for a constant pressure in a closed flow, p S p: as S p = 0 for the constant of all pressures, it
/// is what S has on its diagonal for the prescribed one. Mp gives far more: p Mp p is the whole mass. The prescribed
/// one may be left out of Mp; the least of its diagonal is taken, for too much costs accuracy, too little an iteration.
void SaddleSolver::find_constant(const SparseMatrix& K) {
  free_.assign(pressures_.size(), 0.0);
  constant_ = 0;
  if (!closed_ || viscous_ == 0) return;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < pressures_.size(); ++i) {
    const auto j = static_cast<std::size_t>(pressures_[i]);
    for (auto k = static_cast<std::size_t>(K.start[j]); k < static_cast<std::size_t>(K.start[j + 1]); ++k)
      if (K.value[k] != 0 && K.row[k] != pressures_[i]) free_[i] = 1;
    for (auto k = static_cast<std::size_t>(Mp_.start[i]); k < static_cast<std::size_t>(Mp_.start[i + 1]); ++k)
      if (Mp_.row[k] == static_cast<std::int64_t>(i)) least = std::min(least, Mp_.value[k]);
  }
  C_.multiply(free_, q_);
  for (std::size_t i = 0; i < q_.size(); ++i) constant_ += free_[i] * q_[i];
  constant_ = std::abs(constant_) + least / std::abs(viscous_);
}

bool SaddleSolver::solve(const SparseMatrix& K, std::span<const double> b, std::span<double> x, double tolerance) {
  iterations_ = 0, renewed_ = false;
  if (factorised_ && (pressure_factorised_ || renew_pressure(K)) && iterate(K, b, x, tolerance, patience_)) return true;
  const int before = iterations_;
  const bool solved = renew(K) && iterate(K, b, x, tolerance, most_iterations);
  // Where new factors, too, take many iterations it does not help to make them at once.
  patience_ = std::clamp(3 * (iterations_ - before) / 2, least_patience, most_iterations);
  return solved;
}

bool SaddleSolver::iterate(const SparseMatrix& K, std::span<const double> b, std::span<double> x, double tolerance,
                           int most) {
  const auto multiply = [&](std::span<const double> v, std::span<double> y) { K.multiply(v, y); };
  const auto inverse = [&](std::span<const double> r, std::span<double> z) { precondition(K, r, z); };
  const KrylovResult result = gmres(multiply, inverse, b, x, tolerance, restart, most);
  iterations_ += result.iterations;
  return result.converged;
}

/// z = P^-1 r: p = S^-1 r_p, u = A^-1 (r_u - G p).
void SaddleSolver::precondition(const SparseMatrix& K, std::span<const double> r, std::span<double> z) {
  for (std::size_t i = 0; i < rp_.size(); ++i) rp_[i] = r[static_cast<std::size_t>(pressures_[i])];
  solve_pressure();
  std::copy(r.begin(), r.end(), z.begin());
  for (std::size_t i = 0; i < p_.size(); ++i) {
    const auto j = static_cast<std::size_t>(pressures_[i]);
    for (auto k = static_cast<std::size_t>(K.start[j]); k < static_cast<std::size_t>(K.start[j + 1]); ++k)
      z[static_cast<std::size_t>(K.row[k])] -= K.value[k] * p_[i];
  }
  for (std::size_t i = 0; i < ru_.size(); ++i) ru_[i] = z[static_cast<std::size_t>(velocities_[i])];
  velocity_.solve(ru_, u_);
  for (std::size_t i = 0; i < ru_.size(); ++i) z[static_cast<std::size_t>(velocities_[i])] = u_[i];
  for (std::size_t i = 0; i < p_.size(); ++i) z[static_cast<std::size_t>(pressures_[i])] = p_[i];
}

/// p = S^-1 r_p.
void SaddleSolver::solve_pressure() {
  std::fill(p_.begin(), p_.end(), 0.0);
  const double sign = viscous_ < 0 || inertial_ < 0 ? -1 : 1;
  const auto add = [&](SparseSolver& solver) {
    solver.solve(rp_, q_);
    for (std::size_t i = 0; i < p_.size(); ++i) p_[i] += sign * q_[i];
  };
  if (viscous_ != 0) add(mass_);
  if (constant_ > 0) {
    double sum = 0;
    for (std::size_t i = 0; i < p_.size(); ++i) sum += free_[i] * rp_[i];
    for (std::size_t i = 0; i < p_.size(); ++i) p_[i] += sign * sum / constant_ * free_[i];
  }
  if (inertial_ != 0) add(laplacian_);
}

double SaddleSolver::factor_nonzeros() const {
  return velocity_.factor_nonzeros() + (viscous_ != 0 ? mass_.factor_nonzeros() : 0) +
         (inertial_ != 0 ? laplacian_.factor_nonzeros() : 0);
}

}  // namespace tether
