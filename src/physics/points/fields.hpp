// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "model/scene.hpp"
#include "physics/common_columns.hpp"
#include "physics/points/derived.hpp"
#include "physics/points/state.hpp"
#include "physics/points/steps.hpp"
#include "results/results.hpp"

namespace tether::mpm {

struct PointSetting : ColumnSetting {
  const Scene& scene;
};

/// What a record of material points is made from.
struct PointSums : CommonSums {
  const State& state;
  const Scene& scene;
  Order order;
  Energies energies;
  double carried = 0;  // APIC: kinetic energy of points that run by lanes [energy]
};

/// Lists what the material point path can write: the history's columns, those of a scene and what a record of them is
/// made from, and fields of points and nodes. Points come in the order of the scene, whatever slots they stand in.
const ColumnTable<PointSetting, PointSums>& history_table();
Columns<PointSums> history_columns(const Scene& scene);
PointSums sums_of(const State& state, const Scene& scene);
FieldsInTurn point_fields(const State& state, const Scene& scene);
Snapshot grid_fields(const State& state, const Scene& scene, const StepSet& set);

}  // namespace tether::mpm
