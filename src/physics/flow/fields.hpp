// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "grid/mesh_place.hpp"
#include "model/flow.hpp"
#include "physics/flow/columns.hpp"
#include "physics/flow/elements.hpp"
#include "physics/flow/forces.hpp"
#include "physics/flow/state.hpp"
#include "physics/flow/step.hpp"
#include "physics/flow/stream_function.hpp"
#include "physics/flow/tracers.hpp"
#include "results/results.hpp"

namespace tether::fem {

// What a flow writes.

/// What records and snapshots of a flow are made from. All must outlive it.
class FlowFields {
 public:
  FlowFields(const Flow& flow, const FlowStep& step, const FlowTracers& tracers);

  HistoryLayout history_layout() const { return columns_.layout(); }
  Record record(const FlowState& state) const { return columns_.record(sums_of(state)); }
  /// Places, velocities, pressure, stream function and vorticity at all nodes.
  Snapshot node_fields(const FlowState& state) const;
  /// Places, displacements, velocities and stress of immersed solids' nodes; no fields without any.
  Snapshot body_fields(const FlowState& state) const;

 private:
  FlowMoment last_moment(const FlowState& state) const;
  FlowSums sums_of(const FlowState& state) const;
  void add_probes(const FlowState& state, const std::vector<double>& psi, FlowSums& sums) const;
  void add_bodies(const FlowState& state, FlowSums& sums) const;

  const Flow& flow_;
  const FlowStep& step_;
  const FlowTracers& tracers_;
  StreamFunction stream_;
  FlowForces forces_;
  Columns<FlowSums> columns_;
  std::vector<MeshPlace> probes_;
  std::vector<std::vector<double>> body_volumes_;  // of each region of the solids, its nodes' parts at the start
};

}  // namespace tether::fem
