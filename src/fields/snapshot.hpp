// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "fields/quantity.hpp"

namespace tether {

/// One field of a snapshot: one number for each point (or node).
struct Field {
  Quantity quantity;
  std::vector<double> values;
};

/// Fields of all points, or of all nodes, at one time. For points the fields `x` and `y` and `id` come first.
struct Snapshot {
  double time = 0;
  std::vector<Field> fields;
};

}  // namespace tether
