// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "model/scene.hpp"
#include "plan/plan.hpp"
#include "results/results.hpp"

namespace tether {

/// Motions by less than this part of a cell a step are at rest: what they lose is nothing, and their energy is no
/// measure of another.
constexpr double resting = 1e-6;

/// Returns whether energy is exchanged over time, so that energy_drift and its like have a meaning: a row of equilibria
/// and steady flows has no time in it, and a box without columns of what goes through its sides no balance.
bool balances_energy(const Scene& scene, const HistoryLayout& layout);

/// Returns what summary.txt says of a run because of what its scene is, from the plan and the whole history.
Summary scene_summary(const Plan& plan, const History& history);

/// Says what to say of a run whose method itself lost much of the energy, on points or in a fluid in a box; empty where
/// there is nothing to say.
std::vector<std::string> lost_energy_warnings(const Scene& scene, const History& history);

}  // namespace tether
