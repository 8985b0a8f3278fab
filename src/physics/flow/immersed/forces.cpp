// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/flow/immersed/forces.hpp"

#include <algorithm>

namespace tether::fem {
namespace {

/// A held node lies on a wall where the fluid's functions of the wall's nodes are nearly all there is: on curved walls
/// nodes stand a little off the fluid's sides, whose curves only come near.
constexpr double least_part_on_walls = 0.9;

bool is_wall(Boundary boundary) {
  return boundary == Boundary::no_slip || boundary == Boundary::moving || boundary == Boundary::slip;
}

PlaneForce plane_force(const double* numbers) { return {numbers[0], numbers[1], numbers[2]}; }

void write(const PlaneForce& force, double* to) { to[0] = force.x, to[1] = force.y, to[2] = force.torque; }

}  // namespace

BodyForce body_force(std::span<const double> body_forces, std::size_t body) {
  const double* of = &body_forces[BodyForce::size * body];
  return {plane_force(of), {of[3], of[4]}, {of[5], of[6]}, {of[7], of[8]}};
}

Clamp clamp(std::span<const double> clamps, std::size_t bodies, std::size_t force, std::size_t body) {
  const double* of = &clamps[Clamp::size * (force * bodies + body)];
  return {plane_force(of), plane_force(of + 3)};
}

ImmersedForces::ImmersedForces(const ImmersedSolids& immersed, const FlowUnknowns& unknowns,
                               const FlowElements& elements, double gravity)
    : immersed_(immersed),
      unknowns_(unknowns),
      elements_(elements),
      gravity_(gravity),
      finder_(unknowns.flow.mesh),
      on_wall_(unknowns.pressure.size(), 0.0) {
  const Flow& flow = unknowns.flow;
  for (const FlowSide& side : flow.sides) {
    for (const int node : side.sides) {
      if (is_wall(side.boundary)) on_wall_[static_cast<std::size_t>(flow.twin[static_cast<std::size_t>(node)])] = 1;
    }
  }
  const SolidSystem& system = immersed.system();
  const std::size_t regions = immersed.solids().regions.size(), nodes = system.unknowns() / 2;
  std::vector<double> all(nodes, 0.0);
  for (std::size_t r = 0; r < regions; ++r) {
    shares_.push_back(system.elements->lumped_volumes(static_cast<int>(r)));
    for (std::size_t n = 0; n < nodes; ++n) all[n] += shares_[r][n];
  }
  for (auto& shares : shares_) {
    for (std::size_t n = 0; n < nodes; ++n) shares[n] = all[n] > 0 ? shares[n] / all[n] : 0;
  }
  for (const ForceSide& force : flow.forces) nodes_.push_back(node_shares_of(flow, force));
  held_.resize(2 * nodes), free_.resize(2 * nodes), given_.resize(unknowns.velocity.size());
}

void ImmersedForces::start(FlowState& state) const {
  state.body_forces.assign(BodyForce::size * shares_.size(), 0.0);
  state.clamps.assign(Clamp::size * shares_.size() * nodes_.size(), 0.0);
}

void ImmersedForces::record(const FlowMoment& m, FlowState& state) {
  const Mesh& mesh = immersed_.solids().mesh;
  const auto step = immersed_.last_step();
  const auto rates = body_rates(mesh, step.motion);
  find_stress(m);
  start(state);
  for (std::size_t r = 0; r < shares_.size(); ++r) {
    split_forces(r);
    record_body(r, rates[r], std::span(state.body_forces).subspan(BodyForce::size * r, BodyForce::size));
    for (std::size_t k = 0; k < nodes_.size(); ++k)
      record_clamp(k, std::span(state.clamps).subspan(Clamp::size * (k * shares_.size() + r), Clamp::size));
  }
}

void ImmersedForces::find_stress(const FlowMoment& m) {
  stress_.clear();
  for (const auto& place : body_points(immersed_.solids().mesh, immersed_.last_step().motion.places)) {
    const auto found = finder_.find(place);
    stress_.push_back(found ? elements_.stress_at(m, static_cast<std::size_t>(found->element), found->s)
                            : std::array<double, 3>{});
  }
}

void ImmersedForces::split_forces(std::size_t body) {
  const auto step = immersed_.last_step();
  const auto& held = immersed_.system().held;
  for (std::size_t k = 0; k < held.size(); ++k) {
    const double force = shares_[body][k / 2] * step.forces[k];
    held_[k] = held[k] ? force : 0, free_[k] = held[k] ? 0 : force;
  }
  immersed_.lead_to_carried(free_, held_);
  add_body_inertia(immersed_.solids().mesh, step.motion, static_cast<int>(body), unknowns_.flow.density,
                   step.loaded * gravity_, free_);
  add_body_stress(immersed_.solids().mesh, step.motion.places, static_cast<int>(body), stress_, free_);
  std::fill(given_.begin(), given_.end(), 0.0);
  immersed_.spread(free_, given_);
  for (std::size_t k = 0; k < given_.size(); ++k) {
    if (unknowns_.velocity[k] >= 0) given_[k] = 0;
  }
}

void ImmersedForces::record_body(std::size_t body, const BodyRates& rates, std::span<double> to) const {
  const auto places = immersed_.last_step().motion.places;
  const auto& c = rates.centre;
  const auto sum_of = [&](std::span<const double> f, std::span<const double> x) {
    PlaneForce sum;
    for (std::size_t k = 0; k < f.size(); k += 2) {
      if (f[k] != 0 || f[k + 1] != 0) sum.add(f[k], f[k + 1], x[k] - c[0], x[k + 1] - c[1]);
    }
    return sum;
  };
  const PlaneForce held = sum_of(held_, places), given = sum_of(given_, unknowns_.flow.mesh.x);
  PlaneForce fluid = sum_of(free_, places);
  fluid.add(given, -1);
  const double density = immersed_.solids().regions[body].density;
  write(fluid, to.data());
  to[3] = held.x + given.x, to[4] = held.y + given.y;
  to[5] = density * rates.acceleration[0], to[6] = density * rates.acceleration[1];
  to[7] = c[0], to[8] = c[1];
}

/// The part of a carried node's velocity that is of walls.
double ImmersedForces::part_on_walls(std::size_t carried) const {
  const ImmersedMap& map = immersed_.map();
  const auto nodes = map.nodes(map.cell_of(carried));
  const auto parts = map.parts(carried);
  double part = 0;
  for (std::size_t a = 0; a < nodes.size(); ++a) part += parts[a] * on_wall_[static_cast<std::size_t>(nodes[a])];
  return part;
}

/// Records what the force's nodes have of the body, with their shares. A wall's load is the other way round.
void ImmersedForces::record_clamp(std::size_t force, std::span<double> to) const {
  const Flow& flow = unknowns_.flow;
  const auto& centre = flow.forces[force].centre;
  std::vector<double> share(flow.twin.size(), 0.0);
  Clamp clamp;
  for (const auto& [n, of, part] : nodes_[force]) {
    share[of] += part;
    clamp.given.add(-part * given_[2 * of], -part * given_[2 * of + 1], flow.mesh.x[2 * n] - centre[0],
                    flow.mesh.x[2 * n + 1] - centre[1]);
  }
  const ImmersedMap& map = immersed_.map();
  const auto places = immersed_.last_step().motion.places;
  const std::vector<int>& carried = immersed_.carried().nodes();
  for (std::size_t c = 0; c < carried.size(); ++c) {
    const auto n = static_cast<std::size_t>(carried[c]);
    if (held_[2 * n] == 0 && held_[2 * n + 1] == 0) continue;
    const double on_walls = part_on_walls(c);
    if (on_walls < least_part_on_walls) continue;
    const auto nodes = map.nodes(map.cell_of(c));
    const auto parts = map.parts(c);
    double part = 0;
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      const auto node = static_cast<std::size_t>(nodes[a]);
      part += parts[a] / on_walls * on_wall_[node] * share[node];
    }
    clamp.held.add(-part * held_[2 * n], -part * held_[2 * n + 1], places[2 * n] - centre[0],
                   places[2 * n + 1] - centre[1]);
  }
  write(clamp.held, to.data()), write(clamp.given, to.data() + 3);
}

}  // namespace tether::fem
