// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "physics/points/derived.hpp"
#include "physics/points/steps.hpp"

namespace tether::mpm {

/// Puts the forces across a strip that runs as one row, V sigma dW/dy, which the walls take: they depend on where
/// points lie across, and are those of all of its points, not of its row. In the middle both rows of nodes have half of
/// a point's weight. `order` is that of the row's points.
void put_forces_across(const State& state, const Scene& scene, const StepSet& set, const Order& order,
                       NodeSumsRow& sums);

}  // namespace tether::mpm
