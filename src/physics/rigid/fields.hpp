// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "physics/common_columns.hpp"
#include "physics/rigid/step.hpp"
#include "results/results.hpp"

namespace tether::fem {

struct RigidSetting : ColumnSetting {
  bool pinned = false;
};

/// What a record of a rigid body is made from.
struct RigidSums : CommonSums {
  double work = 0;  ///< of the loads so far [energy]
  Components omega{};
  std::array<Components, 3> directors{};  ///< [length]
  double constraint_error = 0, pin_slip = 0;
};

/// Lists what a rigid body can write: the history's columns and what a record of them is made from, and places and
/// velocities of its mesh's nodes. All velocities and momenta are those of the rigid motion with the state's momenta
/// (state.hpp); the kinetic energy is the state's, which is the one that steps keep.
const ColumnTable<RigidSetting, RigidSums>& rigid_table();
Columns<RigidSums> rigid_columns(const Solids& solids, const Rigid& rigid);
RigidSums sums_of(const RigidRunState& state, const RigidSystem& system);
Snapshot node_fields(const RigidRunState& state, const RigidSystem& system);

}  // namespace tether::fem
