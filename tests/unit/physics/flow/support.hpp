// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include "grid/block_mesh.hpp"
#include "model/flow.hpp"
#include "physics/flow/step.hpp"
#include "unit/alone.hpp"

// Flows on rectangles for tests.

namespace tether::fem {

/// Expressions in x, y, t.
inline FlowVector flow_vector(const std::string& u, const std::string& v) {
  const std::vector<std::string> names{"x", "y", "t"};
  FlowVector vector;
  vector.component = {std::make_shared<const Expression>(u, names), std::make_shared<const Expression>(v, names)};
  return vector;
}

/// Conditions of a rectangle's sides bottom, right, top, left.
struct RectangleSide {
  Boundary boundary = Boundary::no_slip;
  FlowVector velocity = {};
};

/// nx x ny elements over 0 .. width, 0 .. height; density 1.
inline Flow rectangle_flow(FlowElement element, int nx, int ny, double width, double height,
                           const std::array<RectangleSide, 4>& sides) {
  Block block;
  const std::array<std::array<double, 2>, 4> corners{{{0, 0}, {width, 0}, {width, height}, {0, height}}};
  for (std::size_t k = 0; k < 4; ++k) block.edges[k] = straight(corners[k], corners[(k + 1) % 4]);
  block.cells = {nx, ny, 1};
  std::vector<MeshFlaw> flaws;
  Flow flow;
  flow.element = element;
  flow.mesh = mesh_of_blocks({block}, element == FlowElement::q1q1 ? ElementKind::quad4 : ElementKind::quad9, flaws);
  flow.density = 1, flow.viscosity = 1, flow.tolerance = 1e-12;
  const std::array names{"1.bottom", "1.right", "1.top", "1.left"};
  for (std::size_t k = 0; k < 4; ++k)
    flow.sides.push_back({names[k], sides[k].boundary, flow.mesh.sides.at(names[k]), sides[k].velocity, 1});
  flow.twin.resize(flow.mesh.node_count());
  std::iota(flow.twin.begin(), flow.twin.end(), 0);
  return flow;
}

/// A flow with its step, from the flow's start.
struct RunningFlow {
  RunningFlow(const Flow& of, double gravity = 0, const Solids* solids = nullptr)
      : unknowns(of), step(unknowns, solids, gravity, alone()) {
    state.v.resize(unknowns.velocity.size()), state.p.resize(unknowns.pressure.size());
    state.force.resize(unknowns.velocity.size());
    for (std::size_t n = 0; n < of.mesh.node_count(); ++n) {
      const auto v = of.start.at(of.mesh.x[2 * n], of.mesh.x[2 * n + 1], 0);
      state.v[2 * n] = v[0], state.v[2 * n + 1] = v[1];
    }
    unknowns.prescribe(0, state.v);
    state.v_before = state.v;
    if (step.immersed()) step.immersed()->start(state, 1e-3);
  }
  /// Steps of dt to the time; false where one does not converge.
  bool run(double until, double dt) {
    while (state.time < until - 1e-9 * dt) {
      if (!step.advance(state, {state.time, dt, until}).converged) return false;
      state.time += dt;
    }
    return true;
  }
  /// Root of the mean square over nodes of a velocity less the exact one.
  double velocity_error(const std::function<std::array<double, 2>(double, double)>& exact) const {
    double sum = 0;
    const Mesh& mesh = unknowns.flow.mesh;
    for (std::size_t n = 0; n < mesh.node_count(); ++n) {
      const auto v = exact(mesh.x[2 * n], mesh.x[2 * n + 1]);
      sum += std::pow(state.v[2 * n] - v[0], 2) + std::pow(state.v[2 * n + 1] - v[1], 2);
    }
    return std::sqrt(sum / static_cast<double>(mesh.node_count()));
  }
  /// The same of pressures at the nodes that have one, each less its mean.
  double pressure_error(const std::function<double(double, double)>& exact) const {
    std::vector<double> difference;
    const Mesh& mesh = unknowns.flow.mesh;
    for (std::size_t e = 0; e < mesh.element_count(); ++e) {
      for (const int a : pressure_nodes(unknowns.flow.element)) {
        const auto n = static_cast<std::size_t>(mesh.element(e)[a]);
        difference.push_back(state.p[n] - exact(mesh.x[2 * n], mesh.x[2 * n + 1]));
      }
    }
    const auto count = static_cast<double>(difference.size());
    const double mean = std::accumulate(difference.begin(), difference.end(), 0.0) / count;
    double sum = 0;
    for (const double d : difference) sum += (d - mean) * (d - mean);
    return std::sqrt(sum / count);
  }

  FlowUnknowns unknowns;
  FlowStep step;
  FlowState state;
};

}  // namespace tether::fem
