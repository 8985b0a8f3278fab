// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/two_level.hpp"

#include <utility>

#include "base/numbers.hpp"

namespace tether {
namespace {

/// The rows and columns of A that are listed.
SparseMatrix part_of(const SymmetricRows& A, std::span<const std::size_t> listed) {
  std::vector<int> number(at(A.n), -1);
  for (std::size_t k = 0; k < listed.size(); ++k) number[listed[k]] = static_cast<int>(k);
  std::vector<Eigen::Triplet<double, std::int64_t>> entries;
  for (std::size_t k = 0; k < listed.size(); ++k) {
    const std::size_t row = listed[k];
    entries.emplace_back(k, k, A.diagonal[row]);
    for (auto e = static_cast<std::size_t>(A.start[row]); e < static_cast<std::size_t>(A.start[row + 1]); ++e) {
      const int column = number[at(A.column[e])];
      if (column >= 0) entries.emplace_back(k, column, A.value[e]);
    }
  }
  const auto n = static_cast<Eigen::Index>(listed.size());
  EigenSparse part(n, n);
  part.setFromTriplets(entries.begin(), entries.end());
  return sparse_of(part);
}

}  // namespace

bool TwoLevelPreconditioner::set_up(SymmetricRows A, const CoarseUnknowns& coarse) {
  A_ = std::move(A);
  interpolation_ = coarse.interpolation, stiff_ = coarse.stiff;
  const SparseMatrix columns = columns_of(A_);
  const EigenSparse P = interpolation_, product = eigen_of(columns) * P, small = P.transpose() * product;
  coarse_.assign(static_cast<std::size_t>(P.cols()), 0.0), part_.assign(stiff_.size(), 0.0);
  left_.assign(at(A_.n), 0.0);
  return of_coarse_.factorise(sparse_of(small), Definite::positive) &&
         (stiff_.empty() || of_stiff_.factorise(part_of(A_, stiff_), Definite::positive));
}

/// The sum over entries first to last of value times z.
double TwoLevelPreconditioner::sum_of(std::int64_t first, std::int64_t last, std::span<const double> z) const {
  double sum = 0;
  for (auto e = static_cast<std::size_t>(first); e < static_cast<std::size_t>(last); ++e)
    sum += A_.value[e] * z[at(A_.column[e])];
  return sum;
}

double TwoLevelPreconditioner::residual(std::size_t row, std::span<const double> r, std::span<const double> z) const {
  return r[row] - A_.diagonal[row] * z[row] - sum_of(A_.start[row], A_.start[row + 1], z);
}

/// From z = 0: what is right of a row's diagonal is 0 as it is swept, and alone is left after it.
void TwoLevelPreconditioner::sweep_forward(std::span<const double> r, std::span<double> z) {
  for (std::size_t row = 0; row < z.size(); ++row)
    z[row] = (r[row] - sum_of(A_.start[row], A_.middle[row], z)) / A_.diagonal[row];
  for (std::size_t row = 0; row < z.size(); ++row) left_[row] = -sum_of(A_.middle[row], A_.start[row + 1], z);
}

void TwoLevelPreconditioner::sweep_backward(std::span<const double> r, std::span<double> z) const {
  for (std::size_t row = z.size(); row-- > 0;) z[row] += residual(row, r, z) / A_.diagonal[row];
}

void TwoLevelPreconditioner::add_stiff(std::span<double> z) {
  of_stiff_.solve(part_, part_);
  for (std::size_t k = 0; k < stiff_.size(); ++k) z[stiff_[k]] += part_[k];
}

/// Takes what it adds from the residual.
void TwoLevelPreconditioner::solve_stiff_first(std::span<double> z) {
  for (std::size_t k = 0; k < stiff_.size(); ++k) part_[k] = left_[stiff_[k]];
  add_stiff(z);
  for (std::size_t k = 0; k < stiff_.size(); ++k) {
    const std::size_t row = stiff_[k];
    left_[row] -= A_.diagonal[row] * part_[k];
    for (auto e = static_cast<std::size_t>(A_.start[row]); e < static_cast<std::size_t>(A_.start[row + 1]); ++e)
      left_[at(A_.column[e])] -= A_.value[e] * part_[k];
  }
}

void TwoLevelPreconditioner::solve_stiff_again(std::span<const double> r, std::span<double> z) {
  for (std::size_t k = 0; k < stiff_.size(); ++k) part_[k] = residual(stiff_[k], r, z);
  add_stiff(z);
}

void TwoLevelPreconditioner::solve_coarse(std::span<double> z) {
  std::fill(coarse_.begin(), coarse_.end(), 0.0);
  for (std::size_t row = 0; row < z.size(); ++row) {
    for (EigenRows::InnerIterator entry(interpolation_, static_cast<Eigen::Index>(row)); entry; ++entry)
      coarse_[static_cast<std::size_t>(entry.col())] += entry.value() * left_[row];
  }
  of_coarse_.solve(coarse_, coarse_);
  for (std::size_t row = 0; row < z.size(); ++row) {
    for (EigenRows::InnerIterator entry(interpolation_, static_cast<Eigen::Index>(row)); entry; ++entry)
      z[row] += entry.value() * coarse_[static_cast<std::size_t>(entry.col())];
  }
}

void TwoLevelPreconditioner::precondition(std::span<const double> r, std::span<double> z) {
  sweep_forward(r, z);
  if (!stiff_.empty()) solve_stiff_first(z);
  solve_coarse(z);
  if (!stiff_.empty()) solve_stiff_again(r, z);
  sweep_backward(r, z);
}

}  // namespace tether
