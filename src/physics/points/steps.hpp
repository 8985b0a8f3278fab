// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/scene.hpp"
#include "physics/points/point_laws.hpp"
#include "physics/points/state.hpp"

namespace tether::mpm {

/// A step's workplace: the state it changes and what it found on the way.
struct StepWork {
  State& state;
  const Scene& scene;
  StepFindings found;
  NodeTotals nodes = {};
  bool records = true;  // the points' velocities are wanted after the step
};

/// What of a quantity stands beyond walls: the quantity itself, or that of a vector's component, whose sign may turn.
enum class Parity { even, of_x, of_y };

/// What a method does with a state, compiled for its kernel, transfer and geometry, and chosen once for a run.
struct StepSet {
  /// One step of length dt. It begins and ends with mass and momentum (and, but for usf, force) mapped to the nodes.
  /// After trouble the state is for reading only.
  void (*step)(StepWork& work, double dt);
  /// Adds mass, momentum and internal force of all points at their present places to `sums` (3.15), (3.16).
  void (*map_all)(const State& state, const Scene& scene, NodeSumsRow& sums);
  /// Marks the nodes that points reach. Their places must lie inside the frame.
  void (*list_active)(State& state);
  /// Cells that hold points.
  std::size_t (*count_cells)(const State& state, const Scene& scene);
  /// sum_p m_p q_p N_i of a quantity q of all points, added to `values`.
  void (*map_quantity)(const State& state, const std::vector<double>& q, std::vector<double>& values, Parity parity);
  /// The pressure that the nodes' forces have of gas whose density comes from the nodes, by slot; empty without such.
  std::vector<double> (*gas_pressures)(const State& state, const Scene& scene);
  /// At the start: the fields about points that begin with different velocities, where points carry such.
  void (*fit_fields)(State& state);
};

StepSet step_set(const Scene& scene);
StepSet linear_step_set(const Scene& scene);
StepSet spline_step_set(const Scene& scene);

}  // namespace tether::mpm
