// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plan/plan.hpp"
#include "results/results.hpp"

namespace tether {

/// Whether energy is exchanged over time, so that energy_drift and its like have a meaning: a row of equilibria and
/// steady flows has no time in it, and a box without columns of what goes through its sides no balance.
bool balances_energy(const Scene& scene, const HistoryLayout& layout);

/// What summary.txt says of a run by what its scene is, from the plan and the whole history.
Summary scene_summary(const Plan& plan, const History& history);

}  // namespace tether
