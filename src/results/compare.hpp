// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "results/results.hpp"
#include "scene/scene.hpp"

namespace tether {

/// A quantity of the run beside its exact value. For a profile `here` and `exact` have no meaning and `error` is the L1
/// norm; else `error` is relative.
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

/// Compares the finished run with the solution the scene names (none: an empty comparison). A quantity that the run was
/// too short to show is NaN. The solutions take their constants from the scene: a string's stiffness is E A / L with L
/// from where it is held to its last point and A its points' volume over their spacing.
Comparison compare(const Scene& scene, const History& history, const Snapshot& last_points);

/// `period = ...`, `exact_period = ...`, `error_period = ...` for each merit; only the error for a profile.
Summary summary_of(const Comparison& comparison);

}  // namespace tether
