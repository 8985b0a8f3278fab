// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/fem/flow_forces.hpp"

#include <algorithm>

namespace tether::fem {

FlowForces::FlowForces(const Flow& flow, const FlowStep& step) : flow_(flow), step_(step) {
  for (const ForceSide& force : flow.forces) nodes_.push_back(node_shares_of(flow, force));
  if (!step.immersed()) return;
  const Solids& solids = step.immersed()->solids();
  bodies_ = solids.regions.size();
  sides_ = std::make_unique<BodySideForces>(flow, step.elements(), solids.mesh);
}

std::vector<RecordedForce> FlowForces::of(const FlowState& state, const FlowMoment& m) const {
  std::vector<RecordedForce> forces;
  for (std::size_t k = 0; k < flow_.forces.size(); ++k) {
    PlaneForce all = on_walls(state, m, k), clamps;
    const auto& bodies = flow_.forces[k].bodies;
    for (std::size_t r = 0; r < bodies_; ++r) {
      const Clamp by = clamp(state.clamps, bodies_, k, r);
      all.add(by.held);
      PlaneForce both = by.held;
      both.add(by.given);
      // What walls and bodies that are taken as one give each other is no force on both.
      if (std::ranges::find(bodies, static_cast<int>(r)) != bodies.end())
        all.add(both, -1);
      else
        clamps.add(both);
    }
    all.add(on_bodies(state, k));
    if (state.steps > 0) all.add(on_body_sides(state, m, k));
    forces.push_back({all, clamps});
  }
  return forces;
}

/// Of the nodes of walls; with what free nodes of bodies give these, without what supports take.
PlaneForce FlowForces::on_walls(const FlowState& state, const FlowMoment& m, std::size_t k) const {
  const auto& centre = flow_.forces[k].centre;
  PlaneForce sum;
  const auto add = [&](std::size_t n, double fx, double fy) {
    sum.add(fx, fy, flow_.mesh.x[2 * n] - centre[0], flow_.mesh.x[2 * n + 1] - centre[1]);
  };
  for (const auto& [n, of, part] : nodes_[k]) add(n, -part * state.force[2 * of], -part * state.force[2 * of + 1]);
  if (state.steps == 0) return sum;
  for (const auto& [n, force] : step_.elements().corner_forces(m, k)) add(n, force[0], force[1]);
  return sum;
}

PlaneForce FlowForces::on_bodies(const FlowState& state, std::size_t k) const {
  const auto& centre = flow_.forces[k].centre;
  PlaneForce sum;
  for (const int body : flow_.forces[k].bodies) {
    const BodyForce of = body_force(state.body_forces, static_cast<std::size_t>(body));
    sum.add(of.fluid.x, of.fluid.y, of.centre[0] - centre[0], of.centre[1] - centre[1]);
    sum.torque += of.fluid.torque;
  }
  return sum;
}

/// Where the bodies were as the stress acted.
PlaneForce FlowForces::on_body_sides(const FlowState& state, const FlowMoment& m, std::size_t k) const {
  const ForceSide& force = flow_.forces[k];
  if (force.body_sides.empty()) return {};
  std::vector<double> places = state.q;
  for (std::size_t i = 0; i < places.size(); ++i) places[i] -= (1 - m.theta) * state.dt_last * state.drift[i];
  return sides_->of(force.body_sides, places, force.centre, m);
}

}  // namespace tether::fem
