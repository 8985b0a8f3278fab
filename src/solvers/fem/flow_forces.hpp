// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "model/flow.hpp"
#include "solvers/fem/body_side_forces.hpp"
#include "solvers/fem/flow_columns.hpp"
#include "solvers/fem/flow_corners.hpp"
#include "solvers/fem/flow_state.hpp"
#include "solvers/fem/flow_step.hpp"

namespace tether::fem {

/// The recorded forces of a flow: on walls, on immersed bodies and on sides of these.
class FlowForces {
 public:
  /// Both must outlive it.
  FlowForces(const Flow& flow, const FlowStep& step);

  /// Each of the deck's forces; `m` is what the last step was about.
  std::vector<RecordedForce> of(const FlowState& state, const FlowMoment& m) const;

 private:
  PlaneForce on_walls(const FlowState& state, const FlowMoment& m, std::size_t k) const;
  PlaneForce on_bodies(const FlowState& state, std::size_t k) const;
  PlaneForce on_body_sides(const FlowState& state, const FlowMoment& m, std::size_t k) const;

  const Flow& flow_;
  const FlowStep& step_;
  std::vector<std::vector<NodeShare>> nodes_;  // of each force
  std::unique_ptr<BodySideForces> sides_;      // null without bodies
  std::size_t bodies_ = 0;
};

}  // namespace tether::fem
