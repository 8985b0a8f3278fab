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
  return of_coarse_.factorise(sparse_of(small), Definite::positive) &&
         (stiff_.empty() || of_stiff_.factorise(part_of(A_, stiff_), Definite::positive));
}

double TwoLevelPreconditioner::residual(std::size_t row, std::span<const double> r, std::span<const double> z) const {
  double sum = r[row] - A_.diagonal[row] * z[row];
  for (auto e = static_cast<std::size_t>(A_.start[row]); e < static_cast<std::size_t>(A_.start[row + 1]); ++e)
    sum -= A_.value[e] * z[at(A_.column[e])];
  return sum;
}

void TwoLevelPreconditioner::sweep(bool forward, std::span<const double> r, std::span<double> z) const {
  const std::size_t n = z.size();
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t row = forward ? k : n - 1 - k;
    z[row] += residual(row, r, z) / A_.diagonal[row];
  }
}

void TwoLevelPreconditioner::solve_stiff(std::span<const double> r, std::span<double> z) {
  if (stiff_.empty()) return;
  for (std::size_t k = 0; k < stiff_.size(); ++k) part_[k] = residual(stiff_[k], r, z);
  of_stiff_.solve(part_, part_);
  for (std::size_t k = 0; k < stiff_.size(); ++k) z[stiff_[k]] += part_[k];
}

void TwoLevelPreconditioner::solve_coarse(std::span<const double> r, std::span<double> z) {
  std::fill(coarse_.begin(), coarse_.end(), 0.0);
  for (std::size_t row = 0; row < z.size(); ++row) {
    const double left = residual(row, r, z);
    for (EigenRows::InnerIterator entry(interpolation_, static_cast<Eigen::Index>(row)); entry; ++entry)
      coarse_[static_cast<std::size_t>(entry.col())] += entry.value() * left;
  }
  of_coarse_.solve(coarse_, coarse_);
  for (std::size_t row = 0; row < z.size(); ++row) {
    for (EigenRows::InnerIterator entry(interpolation_, static_cast<Eigen::Index>(row)); entry; ++entry)
      z[row] += entry.value() * coarse_[static_cast<std::size_t>(entry.col())];
  }
}

void TwoLevelPreconditioner::precondition(std::span<const double> r, std::span<double> z) {
  std::fill(z.begin(), z.end(), 0.0);
  sweep(true, r, z);
  solve_stiff(r, z);
  solve_coarse(r, z);
  solve_stiff(r, z);
  sweep(false, r, z);
}

}  // namespace tether
