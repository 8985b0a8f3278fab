// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "model/flow.hpp"
#include "physics/flow/immersed/forces.hpp"
#include "physics/flow/state.hpp"
#include "physics/solids/fields.hpp"

namespace tether::fem {

struct FlowSetting : MeshSetting {
  const Flow& flow;
  bool with_bodies = false;
};

/// What is recorded of one of the deck's forces: all of it, and the clamps' part.
struct RecordedForce {
  PlaneForce all, clamps;
};

/// What is recorded at a probe.
struct Probed {
  double pressure = 0, stream = 0;
  Components velocity{};
};

/// What a record of a flow is made from.
struct FlowSums : MeshSums {
  FlowExchange exchanged;
  double pressure_energy = 0;                ///< [energy]
  double least_stream = 0, most_stream = 0;  ///< [length2/time]
  double reynolds = 0;
  std::vector<RecordedForce> forces;
  double unit_force = 0;  ///< that drag and lift are measured by [force]
  std::vector<Probed> probes;
  std::vector<double> differences;  ///< of pressures [stress]
  std::vector<BodyForce> on_bodies;
  double tracers_inside = 0;
};

/// All columns that the history of a flow may have.
const ColumnTable<FlowSetting, FlowSums>& flow_table();
/// Those of a flow in which these solids are immersed; null: none.
Columns<FlowSums> flow_columns(const Flow& flow, const Solids* solids);

}  // namespace tether::fem
