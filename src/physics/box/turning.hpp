// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "physics/solids/system.hpp"

namespace tether::coupled {

/// Returns what a linear step of length h gives the regions of bodies by their turning, at places q with velocities u,
/// over all their energy of motion.
double gain_by_turning(const fem::SolidSystem& system, std::span<const double> q, std::span<const double> u, double h);

}  // namespace tether::coupled
