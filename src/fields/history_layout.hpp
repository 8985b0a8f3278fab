// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "fields/quantity.hpp"

namespace tether {

/// What a history holds: its quantities in order (the first is `time`), and what the bodies and points are called.
struct HistoryLayout {
  std::vector<Quantity> quantities;
  std::vector<std::string> body_names;
  std::vector<std::string> point_names;
  /// Numbers of quantity q: 1, or the number of bodies, or the number of tracked points.
  std::size_t count(const Quantity& q) const;
  /// Names of the flat columns in order: `time`, ... `body_x_1`, `body_x_2`, ... `point_y_1`.
  std::vector<std::string> column_names() const;
};

/// One record: the numbers of all quantities, one after the other, as many as column_names().
using Record = std::vector<double>;

}  // namespace tether
