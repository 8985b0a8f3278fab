// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "loops/instruction_set.hpp"
#include "loops/nodes.hpp"

namespace tether::mpm {

// What a step does at the nodes, by lanes: a lane for each of neighbouring nodes.

/// Rows of the nodes, node 0 first.
struct NodeRows {
  double *m, *momentum_x, *momentum_y, *force_x, *force_y;
  double *convected_x, *convected_y, *a_x, *a_y, *u_x, *u_y;
};

/// Sums over nodes, as NodeTotals has them.
struct LaneTotals {
  double power = 0, squares = 0, gained = 0, upward = 0;

  /// Adds what was found at later nodes.
  void join(const LaneTotals& later) {
    power += later.power, squares += later.squares, gained += later.gained, upward += later.upward;
  }
};

/// What is the same for all nodes of a solve.
struct NodeStep {
  double gravity, dt;
  double light;              // nodes of no more mass count without m |a|^2 in the balance [mass]
  const std::uint8_t* held;  // what walls hold of each node
  bool clears;               // sums that nobody asks any more
};

/// One table for each instruction set. Walls hold nothing but in the solve.
struct NodePasses {
  using Spans = std::span<const NodeSpan>;
  /// 0 at the nodes of some rows.
  void (*clear)(std::span<double* const> rows, Spans nodes);
  /// v_i = (mv)_i / m_i.
  void (*map_velocity)(const NodeRows& rows, Spans nodes);
  /// The momenta that points gave back, divided by the masses (3.24), after which the sums are 0.
  void (*divide_convected)(const NodeRows& rows, Spans nodes);
  /// a = f / m + g, u = (mv) / m + dt a (3.19), (3.20), walls; returns the sums of the balance of energy.
  LaneTotals (*solve)(const NodeRows& rows, Spans nodes, const NodeStep& step);
};

NodePasses node_passes(InstructionSet set);

}  // namespace tether::mpm
