// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "results/results.hpp"
#include "solvers/fem/rigid_system.hpp"

namespace tether::fem {

/// What a rigid body can write: the history's columns and a record of them, and places and velocities of its mesh's
/// nodes. All velocities and momenta are those of the rigid motion with the state's momenta (rigid_state.hpp); the
/// kinetic energy is the state's, which is the one that steps keep.
HistoryLayout history_layout(const Solids& solids, const Rigid& rigid);
Record record(const RigidRunState& state, const RigidSystem& system);
Snapshot node_fields(const RigidRunState& state, const RigidSystem& system);

}  // namespace tether::fem
