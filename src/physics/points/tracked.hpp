// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "physics/common_columns.hpp"
#include "physics/points/derived.hpp"
#include "physics/points/state.hpp"

namespace tether::mpm {

/// Places and velocities of the scene's tracked points; not numbers of one that has left the grid.
std::vector<TrackedSums> tracked_sums(const State& state, const Scene& scene, const Order& order);

}  // namespace tether::mpm
