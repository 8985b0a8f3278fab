// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/scene.hpp"
#include "results/results.hpp"
#include "solvers/fem/solid_state.hpp"
#include "solvers/fem/solid_system.hpp"

namespace tether::fem {

/// What elastic bodies can write: the history's columns and a record of them, and fields of the nodes: places,
/// displacements, velocities, Cauchy's stress and the energy density.
HistoryLayout history_layout(const Solids& solids);
Record record(const SolidState& state, const SolidSystem& system);
Snapshot node_fields(const SolidState& state, const SolidSystem& system);
/// The element whose volume is the least part of that at the start, and where it is, for a message.
std::string worst_element(const SolidSystem& system, std::span<const double> q);
/// The same fields of nodes at q with velocities v.
Snapshot shape_fields(double time, const SolidSystem& system, std::span<const double> q, std::span<const double> v);

}  // namespace tether::fem
