// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "model/scene.hpp"
#include "results/results.hpp"
#include "results/summary_keys.hpp"

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

// One function a solution of src/reference; compare() chooses.
Comparison compare_riemann(const Scene& scene, const Snapshot& last_points);
Comparison compare_spring(const Scene& scene, const History& history);
Comparison compare_string(const Scene& scene, const History& history);
Comparison compare_pendulum(const Scene& scene, const History& history);
Comparison compare_piston(const Scene& scene, const History& history);
Comparison compare_radial_gas(const Scene& scene, const Snapshot& last_points);
Comparison compare_thin_ring(const Scene& scene, const Snapshot& last_points);

/// A quantity beside its exact value, the error relative to that.
Merit relative_merit(FigureName name, double here, double exact);

/// A field of a snapshot by name; throws std::out_of_range where there is none.
const std::vector<double>& values_of(const Snapshot& snapshot, const std::string& name);

/// Compares the finished run with the solution the scene names (none: an empty comparison). A quantity that the run was
/// too short to show is NaN. The solutions take their constants from the scene: a string's stiffness is E A / L with L
/// from where it is held to its last point and A its points' volume over their spacing.
Comparison compare(const Scene& scene, const History& history, const Snapshot& last_points);

/// `period = ...`, `exact_period = ...`, `error_period = ...` for each merit; only the error for a profile.
Summary summary_of(const Comparison& comparison);

}  // namespace tether
