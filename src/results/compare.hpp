// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/scene.hpp"
#include "results/comparison.hpp"

namespace tether {

/// Compares the finished run with the solution the scene names (none: an empty comparison). A quantity that the run was
/// too short to show is NaN. The solutions take their constants from the scene: a string's stiffness is E A / L with L
/// from where it is held to its last point and A its points' volume over their spacing.
Comparison compare(const Scene& scene, const History& history, const Snapshot& last_points);

/// `period = ...`, `exact_period = ...`, `error_period = ...` for each merit; only the error for a profile.
Summary summary_of(const Comparison& comparison);

}  // namespace tether
