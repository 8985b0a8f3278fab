// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/fem/flow_forces.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "solvers/fem/mesh_fields.hpp"

namespace tether::fem {
namespace {

bool has_coefficients(const Flow& flow) { return flow.speed > 0 && flow.length > 0; }

}  // namespace

FlowForces::FlowForces(const Flow& flow, const FlowStep& step) : flow_(flow), step_(step) {
  for (const ForceSide& force : flow.forces) nodes_.push_back(node_shares_of(flow, force));
  if (!step.immersed()) return;
  const Solids& solids = step.immersed()->solids();
  bodies_ = solids.regions.size();
  sides_ = std::make_unique<BodySideForces>(flow, step.elements(), solids.mesh);
}

void FlowForces::add_columns(HistoryLayout& layout) const {
  const auto add = [&](const std::string& name, Dimension dimension, const std::string& meaning) {
    layout.quantities.push_back({name, dimension, meaning});
  };
  for (std::size_t k = 0; k < flow_.forces.size(); ++k) {
    const std::string number = fmt::format("_{}", k + 1), on = " on " + flow_.forces[k].name;
    const std::string by = sides_ ? " of the fluid and of bodies' clamps" : " of the fluid";
    add("side_force_x" + number, Dimension::force, "force in x" + by + on + ", mean of the last step");
    add("side_force_y" + number, Dimension::force, "force in y" + by + on + ", mean of the last step");
    add("side_torque_z" + number, Dimension::torque, "its torque about the deck's place");
    if (sides_) {
      add("side_clamp_x" + number, Dimension::force, "the clamps' part of it in x");
      add("side_clamp_y" + number, Dimension::force, "the clamps' part of it in y");
      add("side_clamp_torque_z" + number, Dimension::torque, "the clamps' part of the torque");
    }
    if (!has_coefficients(flow_)) continue;
    add("drag" + number, Dimension::number, "force in x over speed^2 length density/2");
    add("lift" + number, Dimension::number, "force in y over the same");
  }
}

void FlowForces::append(const FlowState& state, const FlowMoment& m, Record& record) const {
  for (std::size_t k = 0; k < flow_.forces.size(); ++k) {
    PlaneForce all = on_walls(state, m, k), clamps;
    const auto& of = flow_.forces[k].bodies;
    for (std::size_t r = 0; r < bodies_; ++r) {
      const Clamp by = clamp(state.clamps, bodies_, k, r);
      all.add(by.held);
      PlaneForce both = by.held;
      both.add(by.given);
      // What walls and bodies that are taken as one give each other is no force on both.
      if (std::ranges::find(of, static_cast<int>(r)) != of.end())
        all.add(both, -1);
      else
        clamps.add(both);
    }
    all.add(on_bodies(state, k));
    if (state.steps > 0) all.add(on_body_sides(state, m, k));
    record.insert(record.end(), {all.x, all.y, all.torque});
    if (sides_) record.insert(record.end(), {clamps.x, clamps.y, clamps.torque});
    const double unit = 0.5 * flow_.density * flow_.speed * flow_.speed * flow_.length;
    if (has_coefficients(flow_)) record.insert(record.end(), {all.x / unit, all.y / unit});
  }
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

void FlowForces::add_body_columns(HistoryLayout& layout) {
  constexpr int dim = 2;
  add_vector(layout, "body_force_", Dimension::force, "force of the fluid in the last step, ", dim, Per::body);
  add_vector(layout, "body_hold_", Dimension::force, "force of supports and walls in the last step, ", dim, Per::body);
  add_vector(layout, "body_change_", Dimension::force, "change of the body's momentum by time in it, ", dim, Per::body);
  layout.quantities.push_back(
      {"body_torque_z", Dimension::torque, "torque of the fluid's force about the body's centre", Per::body});
}

/// As add_body_columns() lists them.
void FlowForces::append_bodies(const FlowState& state, Record& record) const {
  const auto append = [&](const auto& number) {
    for (std::size_t r = 0; r < bodies_; ++r) record.push_back(number(body_force(state.body_forces, r)));
  };
  append([](const BodyForce& of) { return of.fluid.x; }), append([](const BodyForce& of) { return of.fluid.y; });
  append([](const BodyForce& of) { return of.hold[0]; }), append([](const BodyForce& of) { return of.hold[1]; });
  append([](const BodyForce& of) { return of.change[0]; }), append([](const BodyForce& of) { return of.change[1]; });
  append([](const BodyForce& of) { return of.fluid.torque; });
}

}  // namespace tether::fem
