// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "solvers/fem/mesh_fields.hpp"
#include "solvers/fem/solid_state.hpp"
#include "solvers/fem/solid_system.hpp"

namespace tether::fem {

/// What a record of elastic bodies is made from.
struct SolidSums : MeshSums {
  double of_loads = 0, of_supports = 0, damped = 0;  ///< so far [energy]
};

/// What elastic bodies can write: the history's columns and what a record of them is made from, and fields of the
/// nodes: places, displacements, velocities, Cauchy's stress and the energy density.
const ColumnTable<ColumnSetting, SolidSums>& solid_table();
Columns<SolidSums> solid_columns(const Solids& solids);
SolidSums sums_of(const SolidState& state, const SolidSystem& system);
Snapshot node_fields(const SolidState& state, const SolidSystem& system);
/// The element whose volume is the least part of that at the start, and where it is, for a message.
std::string worst_element(const SolidSystem& system, std::span<const double> q);

}  // namespace tether::fem
