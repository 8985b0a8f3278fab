// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "base/vec.hpp"

namespace tether {

/// A closed outline, whose pieces are listed by rows of its height: a place asks those of its row alone whether it is
/// inside.
class Outline {
 public:
  /// Corners in their order; the last is joined to the first. Two at least.
  explicit Outline(std::vector<Vec<2>> corners);

  const std::vector<Vec<2>>& corners() const { return corners_; }
  /// Returns whether a ray from the place to the right crosses it an odd number of times.
  bool holds(const Vec<2>& at) const;

 private:
  std::size_t row_of(double y) const;

  std::vector<Vec<2>> corners_;
  double low_ = 0, high_ = 0, rows_per_height_ = 0;
  std::vector<std::vector<std::size_t>> rows_;  // of each: the corners at which pieces end that reach into it
};

}  // namespace tether
