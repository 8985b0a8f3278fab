// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "results/results.hpp"

namespace tether {

/// A quantity of the run next to its exact value. For a profile `here` and `exact` have no meaning and `error` is the
/// L1 norm; else `error` is relative.
struct Merit {
  std::string name;
  double here = 0, exact = 0, error = 0;
  bool profile = false;
};

/// What a run is worth against the exact solution of its scene, and that solution as a table.
struct Comparison {
  std::vector<Merit> merits;
  Table exact;
  std::optional<std::array<double, 2>> window = {};  ///< part of a tube in which profiles are compared, from x to x
};

}  // namespace tether
