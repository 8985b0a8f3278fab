// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/fem/flow_tracers.hpp"

#include "grid/lagrange.hpp"

namespace tether::fem {
namespace {

/// Solids in the shape that their nodes at q give them.
Mesh shape_of(const Solids& solids, const std::vector<double>& q) {
  Mesh mesh = solids.mesh;
  mesh.x = q;
  return mesh;
}

}  // namespace

FlowTracers::FlowTracers(const Flow& flow) : flow_(flow), finder_(flow.mesh) {}

void FlowTracers::start(const Solids* solids, FlowState& state) const {
  const TracerBox& box = flow_.tracers;
  const Mesh shape = solids ? shape_of(*solids, state.q) : Mesh{};
  const std::optional<PointFinder> in_solids = solids ? std::optional<PointFinder>(shape) : std::nullopt;
  for (int j = 0; j < box.count[1]; ++j) {
    for (int i = 0; i < box.count[0]; ++i) {
      const std::array<double, 2> x{box.x0 + (i + 0.5) * (box.x1 - box.x0) / box.count[0],
                                    box.y0 + (j + 0.5) * (box.y1 - box.y0) / box.count[1]};
      if (!finder_.find(x) || (in_solids && in_solids->find(x))) continue;
      state.tracers.insert(state.tracers.end(), x.begin(), x.end());
    }
  }
  state.tracer_left.assign(state.tracers.size() / 2, 0);
}

std::array<double, 2> FlowTracers::velocity(std::span<const double> v, const PointFinder::Found& at) const {
  std::array<double, 2> sum{};
  const int* nodes = flow_.mesh.element(static_cast<std::size_t>(at.element));
  const auto add = [&](const auto& N) {
    for (std::size_t a = 0; a < N.size(); ++a) {
      for (std::size_t i = 0; i < 2; ++i) sum[i] += N[a] * v[2 * static_cast<std::size_t>(nodes[a]) + i];
    }
  };
  if (flow_.mesh.kind == ElementKind::quad4)
    add(ShapesOf<ElementKind::quad4>::values(at.s));
  else
    add(ShapesOf<ElementKind::quad9>::values(at.s));
  return sum;
}

void FlowTracers::advance(FlowState& state, double dt) const {
  if (state.tracers.empty()) return;
  std::vector<double> mean(state.v.size());
  for (std::size_t k = 0; k < mean.size(); ++k) mean[k] = 0.5 * (state.v_before[k] + state.v[k]);
  for (std::size_t n = 0; n < state.tracer_left.size(); ++n) {
    double* x = &state.tracers[2 * n];
    const auto at = finder_.find({x[0], x[1]});
    if (state.tracer_left[n] != 0 || !at) continue;
    const auto first = velocity(mean, *at);
    const auto middle = finder_.find({x[0] + 0.5 * dt * first[0], x[1] + 0.5 * dt * first[1]});
    const auto v = middle ? velocity(mean, *middle) : first;
    x[0] += dt * v[0], x[1] += dt * v[1];
    state.tracer_left[n] = finder_.find({x[0], x[1]}) ? 0 : 1;
  }
}

std::size_t FlowTracers::count_inside(const Solids& solids, const FlowState& state) const {
  const Mesh shape = shape_of(solids, state.q);
  const PointFinder in_solids(shape);
  std::size_t count = 0;
  for (std::size_t n = 0; n < state.tracer_left.size(); ++n)
    count += in_solids.find({state.tracers[2 * n], state.tracers[2 * n + 1]}) ? 1 : 0;
  return count;
}

Snapshot FlowTracers::fields(const FlowState& state) const {
  Snapshot snapshot{state.time, {}};
  const std::size_t count = state.tracer_left.size();
  if (count == 0) return snapshot;
  std::vector<double> x, y, id, vx, vy;
  for (std::size_t n = 0; n < count; ++n) {
    x.push_back(state.tracers[2 * n]), y.push_back(state.tracers[2 * n + 1]), id.push_back(static_cast<double>(n + 1));
    const auto at = finder_.find({x.back(), y.back()});
    const auto v = at && state.tracer_left[n] == 0 ? velocity(state.v, *at) : std::array<double, 2>{};
    vx.push_back(v[0]), vy.push_back(v[1]);
  }
  snapshot.fields = {{{"x", Dimension::length, "place"}, std::move(x)},
                     {{"y", Dimension::length, "place"}, std::move(y)},
                     {{"id", Dimension::number, "number of the tracer, from 1"}, std::move(id)},
                     {{"vx", Dimension::velocity, "velocity in x"}, std::move(vx)},
                     {{"vy", Dimension::velocity, "velocity in y"}, std::move(vy)},
                     {{"left", Dimension::number, "1 of tracers that left the fluid's mesh, which stay where they did"},
                      {state.tracer_left.begin(), state.tracer_left.end()}}};
  return snapshot;
}

}  // namespace tether::fem
