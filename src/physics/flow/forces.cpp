// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/flow/forces.hpp"

#include <algorithm>
#include <cmath>

#include "grid/shapes.hpp"

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

/// Returns the force on the nodes of walls; with what free nodes of bodies give these, without what supports take.
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

/// Returns the force on sides of bodies, where these were as the stress acted.
PlaneForce FlowForces::on_body_sides(const FlowState& state, const FlowMoment& m, std::size_t k) const {
  const ForceSide& force = flow_.forces[k];
  if (force.body_sides.empty()) return {};
  std::vector<double> places = state.q;
  for (std::size_t i = 0; i < places.size(); ++i) places[i] -= (1 - m.theta) * state.dt_last * state.drift[i];
  return sides_->of(force.body_sides, places, force.centre, m);
}

namespace {

Vec<2> beyond(const Vec<2>& at, const Vec<2>& normal, double way) {
  return {at[0] + way * normal[0], at[1] + way * normal[1]};
}

}  // namespace

BodySideForces::BodySideForces(const Flow& flow, const FlowElements& elements, const Mesh& solids)
    : elements_(elements), fluid_(flow.mesh), solids_(solids), finder_(flow.mesh) {}

PlaneForce BodySideForces::of(const Sides& sides, std::span<const double> places, const Vec<2>& centre,
                              const FlowMoment& m) const {
  return order_of(solids_.kind) == 2 ? along<2>(sides, places, centre, m) : along<1>(sides, places, centre, m);
}

/// The mesh's sides go round the body counter-clockwise.
template <int p>
PlaneForce BodySideForces::along(const Sides& sides, std::span<const double> places, const Vec<2>& centre,
                                 const FlowMoment& m) const {
  PlaneForce sum;
  for (std::size_t first = 0; first < sides.size(); first += p + 1) {
    for (std::size_t q = 0; q < 3; ++q) {
      const double s = Line<2>::gauss_places()[q], weight = Line<2>::gauss_weights()[q];
      const auto N = Line<p>::values(s), dN = Line<p>::slopes(s);
      Vec<2> at{}, along{};
      for (std::size_t a = 0; a <= p; ++a) {
        const double* x = &places[2 * static_cast<std::size_t>(sides[first + a])];
        for (std::size_t i = 0; i < 2; ++i) at[i] += N[a] * x[i], along[i] += dN[a] * x[i];
      }
      const double length = std::hypot(along[0], along[1]), area = weight * length;
      const Vec<2> normal{along[1] / length, -along[0] / length};
      const auto [xx, yy, xy] = stress_outside(at, normal, m);
      sum.add(area * (xx * normal[0] + xy * normal[1]), area * (xy * normal[0] + yy * normal[1]), at[0] - centre[0],
              at[1] - centre[1]);
    }
  }
  return sum;
}

/// Square root of the area between the corners of the fluid's element at a place, 0 outside of the mesh.
double BodySideForces::size_at(const Vec<2>& at) const {
  const auto found = finder_.find(at);
  if (!found) return 0;
  const int line = order_of(fluid_.kind), count = node_count_of(fluid_.kind);
  const int* nodes = fluid_.element(static_cast<std::size_t>(found->element));
  const auto corner = [&](int a) { return &fluid_.x[2 * static_cast<std::size_t>(nodes[a])]; };
  const double *a = corner(0), *b = corner(line), *c = corner(count - 1), *d = corner(count - 1 - line);
  return std::sqrt(0.5 * std::abs((c[0] - a[0]) * (d[1] - b[1]) - (c[1] - a[1]) * (d[0] - b[0])));
}

/// From one and two elements away, or nearer where the fluid ends before that; none where it ends within a tenth.
std::array<double, 3> BodySideForces::stress_outside(const Vec<2>& at, const Vec<2>& normal,
                                                     const FlowMoment& m) const {
  constexpr double least = 0.1;
  const double size = size_at(at);
  for (double part = 1; size > 0 && part > least / 2; part /= 2) {
    const auto near = finder_.find(beyond(at, normal, part * size)),
               far = finder_.find(beyond(at, normal, 2 * part * size));
    if (!near || !far) continue;
    const auto of = [&](const PointFinder::Found& found) {
      return elements_.stress_at(m, static_cast<std::size_t>(found.element), found.s);
    };
    const auto first = of(*near), second = of(*far);
    return {2 * first[0] - second[0], 2 * first[1] - second[1], 2 * first[2] - second[2]};
  }
  return {};
}

}  // namespace tether::fem
