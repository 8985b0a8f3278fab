// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "results/results.hpp"

namespace tether {

/// Columns of a history that every path of points in the plane has: of bodies, and of tracked points.
const std::vector<Quantity>& body_quantities();
const std::vector<Quantity>& tracked_quantities();

}  // namespace tether
