// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "grid/mesh_place.hpp"
#include "model/flow.hpp"
#include "results/results.hpp"
#include "solvers/fem/flow_forces.hpp"
#include "solvers/fem/flow_state.hpp"
#include "solvers/fem/flow_step.hpp"
#include "solvers/fem/flow_stream.hpp"
#include "solvers/fem/flow_tracers.hpp"

// What a flow writes.

namespace tether::fem {

/// A column of energy that was exchanged, and what of the state it records.
struct ExchangeColumn {
  const char* name;
  const char* meaning;
  Book book;
  double FlowExchange::*amount;
};

/// What records and snapshots of a flow are made from. All must outlive it.
class FlowFields {
 public:
  FlowFields(const Flow& flow, const FlowStep& step, const FlowTracers& tracers);

  HistoryLayout history_layout() const;
  Record record(const FlowState& state) const;
  /// Places, velocities, pressure, stream function and vorticity at all nodes.
  Snapshot node_fields(const FlowState& state) const;
  /// Places, displacements, velocities and stress of immersed solids' nodes; no fields without any.
  Snapshot body_fields(const FlowState& state) const;

 private:
  FlowMoment last_moment(const FlowState& state) const;
  void append_bodies(const FlowState& state, Record& record) const;
  void append_probes(const FlowState& state, const std::vector<double>& pressure, const std::vector<double>& psi,
                     Record& record) const;

  const Flow& flow_;
  const FlowStep& step_;
  const FlowTracers& tracers_;
  StreamFunction stream_;
  FlowForces forces_;
  std::vector<ExchangeColumn> exchanges_;
  std::vector<MeshPlace> probes_;
  std::vector<std::vector<double>> body_volumes_;  // of each region of the solids, its nodes' parts at the start
};

}  // namespace tether::fem
