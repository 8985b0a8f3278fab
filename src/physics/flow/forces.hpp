// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/vec.hpp"
#include "grid/point_finder.hpp"
#include "model/flow.hpp"
#include "physics/flow/columns.hpp"
#include "physics/flow/elements.hpp"
#include "physics/flow/immersed/forces.hpp"
#include "physics/flow/state.hpp"
#include "physics/flow/step.hpp"
#include "physics/flow/unknowns.hpp"

namespace tether::fem {

/// The force of the fluid's stress on sides of immersed bodies. In the fluid's elements that a body's surface cuts, the
/// stress is of both: it is taken from two places outside of them and led on to the surface in a straight line. Where a
/// side lies on a wall there is no fluid and no force.
class BodySideForces {
 public:
  /// All must outlive it; the sides are those of the solids' mesh.
  BodySideForces(const Flow& flow, const FlowElements& elements, const Mesh& solids);

  /// On these sides, with nodes at `places`, about a centre.
  PlaneForce of(const Sides& sides, std::span<const double> places, const Vec<2>& centre, const FlowMoment& m) const;

 private:
  template <int p>
  PlaneForce along(const Sides& sides, std::span<const double> places, const Vec<2>& centre, const FlowMoment& m) const;
  std::array<double, 3> stress_outside(const Vec<2>& at, const Vec<2>& normal, const FlowMoment& m) const;
  double size_at(const Vec<2>& at) const;

  const FlowElements& elements_;
  const Mesh& fluid_;
  const Mesh& solids_;
  PointFinder finder_;
};

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
