// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace tether::mpm {

/// A symmetric positive definite matrix, of which each row is kept from its first entry to the diagonal: what the
/// Cholesky factor fills. Unknowns that are numbered along a curve have short rows. Memory is kept between uses.
class ProfileMatrix {
 public:
  void reserve(std::size_t rows, std::size_t entries) {
    first_.reserve(rows);
    start_.reserve(rows);
    entries_.reserve(entries);
  }
  /// A matrix of zeros; `first` is each row's first column.
  void shape(std::span<const std::size_t> first) {
    first_.assign(first.begin(), first.end());
    start_.resize(first.size());
    std::size_t entries = 0;
    for (std::size_t i = 0; i < first.size(); ++i) start_[i] = entries, entries += i + 1 - first[i];
    entries_.assign(entries, 0.0);
  }
  std::size_t rows() const { return first_.size(); }
  double& at(std::size_t i, std::size_t j) { return entries_[start_[i] + j - first_[i]]; }
  double at(std::size_t i, std::size_t j) const { return entries_[start_[i] + j - first_[i]]; }

  /// Puts the Cholesky factor in the matrix' place.
  void factor() {
    for (std::size_t i = 0; i < rows(); ++i) {
      for (std::size_t j = first_[i]; j < i; ++j) at(i, j) = (at(i, j) - product(i, j)) / at(j, j);
      at(i, i) = std::sqrt(at(i, i) - product(i, i));
    }
  }
  /// After factor(): from the right-hand side to the solution.
  void solve(std::span<double> x) const {
    for (std::size_t i = 0; i < rows(); ++i) {
      for (std::size_t j = first_[i]; j < i; ++j) x[i] -= at(i, j) * x[j];
      x[i] /= at(i, i);
    }
    for (std::size_t i = rows(); i-- > 0;) {
      x[i] /= at(i, i);
      for (std::size_t j = first_[i]; j < i; ++j) x[j] -= at(i, j) * x[i];
    }
  }

 private:
  /// Of rows i and j over the columns before j that both have.
  double product(std::size_t i, std::size_t j) const {
    double sum = 0;
    for (std::size_t k = std::max(first_[i], first_[j]); k < j; ++k) sum += at(i, k) * at(j, k);
    return sum;
  }

  std::vector<std::size_t> first_, start_;
  std::vector<double> entries_;
};

}  // namespace tether::mpm
