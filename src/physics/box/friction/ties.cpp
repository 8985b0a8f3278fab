// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/friction/ties.hpp"

#include <algorithm>

namespace tether::coupled {
namespace {

constexpr double stiff = 0.05;  // of an unknown's diagonal, which a square that ties it has at least
constexpr int none = -1;

}  // namespace

Ties::Ties(const StrainRates& rates, std::span<const std::size_t> free, std::span<const double> diagonal,
           std::size_t unknowns) {
  for (const double value : diagonal) inverse_.push_back(1 / value);
  std::vector<int> number(unknowns, none), of_tied(free.size(), none);  // among the free ones, and among the tied ones
  for (std::size_t i = 0; i < free.size(); ++i) number[free[i]] = static_cast<int>(i);
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<double> rest(diagonal.begin(), diagonal.end());
  const auto tied = [&](int i) {
    int& known = of_tied[at(i)];
    if (known == none) known = static_cast<int>(tied_.size()), tied_.push_back(at(i));
    return known;
  };
  rates.each_square([&](std::span<const std::size_t> unknown, std::span<const double> factor, double weight) {
    const auto dominates = [&](std::size_t k) {
      const int i = number[unknown[k]];
      return i != none && weight * factor[k] * factor[k] > stiff * diagonal[at(i)];
    };
    bool ties = false;
    for (std::size_t k = 0; k < unknown.size(); ++k) ties = ties || dominates(k);
    if (!ties) return;
    for (std::size_t k = 0; k < unknown.size(); ++k) {
      const int i = number[unknown[k]];
      if (i == none) continue;
      const int row = tied(i);
      rest[at(i)] -= weight * factor[k] * factor[k];
      for (std::size_t l = 0; l < unknown.size(); ++l) {
        if (number[unknown[l]] == none) continue;
        const int column = tied(number[unknown[l]]);
        entries.emplace_back(row, column, weight * factor[k] * factor[l]);
      }
    }
  });
  if (tied_.empty()) return;
  const int size = static_cast<int>(tied_.size());
  for (int k = 0; k < size; ++k) entries.emplace_back(k, k, std::max(rest[tied_[at(k)]], 0.0));
  Eigen::SparseMatrix<double> P(size, size);
  P.setFromTriplets(entries.begin(), entries.end());
  if (!factors_.factorise(P)) tied_.clear();
  right_.resize(std::ssize(tied_)), found_.resize(std::ssize(tied_));
}

void Ties::solve(std::span<const double> r, std::span<double> z) {
  for (std::size_t i = 0; i < r.size(); ++i) z[i] = inverse_[i] * r[i];
  if (tied_.empty()) return;
  for (std::size_t k = 0; k < tied_.size(); ++k) right_[static_cast<Eigen::Index>(k)] = r[tied_[k]];
  factors_.solve(right_, found_);
  for (std::size_t k = 0; k < tied_.size(); ++k) z[tied_[k]] = found_[static_cast<Eigen::Index>(k)];
}

}  // namespace tether::coupled
