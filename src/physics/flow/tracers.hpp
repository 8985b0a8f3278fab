// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "base/team.hpp"
#include "base/vec.hpp"
#include "grid/point_finder.hpp"
#include "model/flow.hpp"
#include "model/solids.hpp"
#include "physics/flow/state.hpp"
#include "results/results.hpp"

namespace tether::fem {

/// Points that go with the fluid and do nothing to it. One that leaves the mesh stays where it left.
class FlowTracers {
 public:
  /// The flow must outlive it.
  explicit FlowTracers(const Flow& flow);

  /// Puts them to the middles of the box's parts, but for those outside of the fluid or inside of solids (null: none),
  /// whose nodes are at state.q.
  void start(const Solids* solids, FlowState& state) const;
  /// Moves them over a step of dt by the mid-point rule in the mean of the velocities at its ends, those of the state.
  void advance(Team& team, FlowState& state, double dt) const;
  /// How many are inside of solids whose nodes are at state.q.
  std::size_t count_inside(const Solids& solids, const FlowState& state) const;
  /// Places, numbers from 1, velocities, and whether they left.
  Snapshot fields(const FlowState& state) const;

 private:
  static constexpr std::size_t tracers_of_a_block = 128;

  bool move(std::span<const double> mean, double dt, double* x) const;
  Vec<2> velocity(std::span<const double> v, const PointFinder::Found& at) const;

  const Flow& flow_;
  PointFinder finder_;
};

}  // namespace tether::fem
