// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "model/scene.hpp"
#include "results/results.hpp"

namespace tether {

/// What to say of a run whose method itself lost much of the energy, on points or in a fluid in a box; empty where
/// there is nothing to say.
std::string lost_energy_warning(const Scene& scene, const History& history);

}  // namespace tether
