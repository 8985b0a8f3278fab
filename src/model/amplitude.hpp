// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/expression.hpp"

namespace tether {

/// A factor over time: an expression in t, or a table, linear between its times, constant before the first and behind
/// the last; 1 without either. Copies share the expression, so that one thread at a time may ask all of them.
struct Amplitude {
  std::vector<double> time, factor;
  std::shared_ptr<const Expression> expression = {};
  std::string of = {};  ///< what it belongs to, for messages: "load 2"
  /// Throws RunError where the expression has no finite value.
  double at(double t) const;
};

}  // namespace tether
