// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "results/results.hpp"

namespace tether {

/// Largest change of the total energy less the work done from outside and with what damping took, over the largest
/// energy that was exchanged: the largest change of any one kind. 0 where nothing was exchanged.
double energy_drift(const History& history);

/// Largest rise of the total energy over the start, over the largest energy that was exchanged.
double energy_rise(const History& history);

/// Largest size of the total energy over its size at the start: how far an unstable run grew. Not a number where the
/// start has none.
double energy_growth(const History& history);

/// Largest change of the mass over the mass at the start.
double mass_drift(const History& history);

}  // namespace tether
