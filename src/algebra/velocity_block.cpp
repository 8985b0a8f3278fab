// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/velocity_block.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

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

}  // namespace tether
