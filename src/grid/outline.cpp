// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/outline.hpp"

#include <algorithm>

namespace tether {

Outline::Outline(std::vector<Vec<2>> corners) : corners_(std::move(corners)), rows_(corners_.size()) {
  const auto lower = [](const Vec<2>& a, const Vec<2>& b) { return a[1] < b[1]; };
  const auto [lowest, highest] = std::minmax_element(corners_.begin(), corners_.end(), lower);
  low_ = (*lowest)[1], high_ = (*highest)[1];
  if (high_ > low_) rows_per_height_ = static_cast<double>(rows_.size()) / (high_ - low_);
  for (std::size_t k = 0, before = corners_.size() - 1; k < corners_.size(); before = k++) {
    const auto [from, to] = std::minmax({row_of(corners_[before][1]), row_of(corners_[k][1])});
    for (std::size_t row = from; row <= to; ++row) rows_[row].push_back(k);
  }
}

/// Grows with y, so that a piece whose ends are in two rows reaches into all between them.
std::size_t Outline::row_of(double y) const {
  const double row = std::clamp((y - low_) * rows_per_height_, 0.0, static_cast<double>(rows_.size() - 1));
  return static_cast<std::size_t>(row);
}

bool Outline::holds(const Vec<2>& at) const {
  if (!(at[1] >= low_ && at[1] <= high_)) return false;
  bool inside = false;
  for (const std::size_t k : rows_[row_of(at[1])]) {
    const Vec<2>&a = corners_[k == 0 ? corners_.size() - 1 : k - 1], &b = corners_[k];
    if ((a[1] > at[1]) != (b[1] > at[1]) && at[0] < a[0] + (at[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]))
      inside = !inside;
  }
  return inside;
}

}  // namespace tether
