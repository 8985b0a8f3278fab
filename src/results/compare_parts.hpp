// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "results/compare.hpp"

namespace tether {

// One function a solution of src/reference; compare() chooses.
Comparison compare_riemann(const Scene& scene, const Snapshot& last_points);
Comparison compare_spring(const Scene& scene, const History& history);
Comparison compare_string(const Scene& scene, const History& history);
Comparison compare_pendulum(const Scene& scene, const History& history);
Comparison compare_piston(const Scene& scene, const History& history);

}  // namespace tether
