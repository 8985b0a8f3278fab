// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "model/scene.hpp"
#include "results/comparison.hpp"

namespace tether {

// One function a solution of src/reference; compare() chooses.
Comparison compare_riemann(const Scene& scene, const Snapshot& last_points);
Comparison compare_spring(const Scene& scene, const History& history);
Comparison compare_string(const Scene& scene, const History& history);
Comparison compare_pendulum(const Scene& scene, const History& history);
Comparison compare_piston(const Scene& scene, const History& history);
Comparison compare_radial_gas(const Scene& scene, const Snapshot& last_points);
Comparison compare_thin_ring(const Scene& scene, const Snapshot& last_points);

/// A quantity beside its exact value, the error relative to that.
Merit relative_merit(const char* name, double here, double exact);

/// A field of a snapshot by name; throws std::out_of_range where there is none.
const std::vector<double>& values_of(const Snapshot& snapshot, const std::string& name);

}  // namespace tether
