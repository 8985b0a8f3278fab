// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/scene.hpp"
#include "results/results.hpp"
#include "solvers/mpm/state.hpp"
#include "solvers/mpm/steps.hpp"

namespace tether::mpm {

/// What the material point path can write: the history's columns and a record of them, and fields of points and nodes.
/// Points come in the order of the scene, whatever slots they stand in.
HistoryLayout history_layout(const Scene& scene);
Record record(const State& state, const Scene& scene);
Snapshot point_fields(const State& state, const Scene& scene);
Snapshot grid_fields(const State& state, const Scene& scene, const StepSet& set);

}  // namespace tether::mpm
