// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/flow/fields.hpp"

#include <algorithm>
#include <numeric>

#include "base/numbers.hpp"
#include "grid/point_finder.hpp"

namespace tether::fem {
namespace {

MeshPlace place_of(const Mesh& mesh, const PointFinder::Found& found) {
  MeshPlace place;
  const int count = node_count_of(mesh.kind);
  const int* nodes = mesh.element(static_cast<std::size_t>(found.element));
  place.nodes.assign(nodes, nodes + count);
  const auto assign = [&](const auto& values) { place.parts.assign(values.begin(), values.end()); };
  with_values_at(mesh.kind, found.s, assign);
  return place;
}

/// What fields of the fluid's nodes are made from.
struct NodeSource {
  const Mesh& mesh;
  const FlowState& state;
  std::vector<double> pressure, stream, vorticity;
};

const ColumnTable<ColumnSetting, NodeSource>& node_table() {
  using S = NodeSource;
  using Row = Column<ColumnSetting, S>;
  using D = Dimension;
  static const ColumnTable<ColumnSetting, S> table({{{
      Row("", D::length, "place", [](const S& s, std::size_t i, std::size_t n) { return s.mesh.x[2 * n + i]; })
          .vector(),
      Row("v", D::velocity, "velocity", [](const S& s, std::size_t i, std::size_t n) { return s.state.v[2 * n + i]; })
          .vector(),
      {"p", D::stress, "pressure, of the last step, before the first one not a number",
       [](const S& s, std::size_t n) { return s.state.dt_last > 0 ? s.pressure[n] : no_number; }},
      {"stream", D::flux, "stream function, zero at the first node",
       [](const S& s, std::size_t n) { return s.stream[n]; }},
      {"vorticity", D::rate, "dv/dx - du/dy, the mean around each node",
       [](const S& s, std::size_t n) { return s.vorticity[n]; }},
  }}});
  return table;
}

}  // namespace

FlowFields::FlowFields(const Flow& flow, const FlowStep& step, const FlowTracers& tracers)
    : flow_(flow),
      step_(step),
      tracers_(tracers),
      stream_(flow, step.elements()),
      forces_(flow, step),
      columns_(flow_columns(flow, step.immersed() ? &step.immersed()->solids() : nullptr)) {
  const PointFinder finder(flow.mesh);
  for (const auto& probe : flow.probes) probes_.push_back(place_of(flow.mesh, finder.find(probe).value()));
  if (!step.immersed()) return;
  for (std::size_t r = 0; r < step.immersed()->solids().regions.size(); ++r)
    body_volumes_.push_back(step.immersed()->system().elements->volumes(static_cast<int>(r)));
}

/// Returns what the last step was about, of a state that a checkpoint held, too.
FlowMoment FlowFields::last_moment(const FlowState& state) const {
  return {.v0 = state.v_before,
          .v1 = state.v,
          .p = state.p,
          .theta = flow_.integrator == FlowIntegrator::midpoint ? 0.5 : 1,
          .viscosity = step_.viscosity(),
          .acceleration = {}};
}

void FlowFields::add_probes(const FlowState& state, const std::vector<double>& psi, FlowSums& sums) const {
  const std::vector<double> pressure = step_.elements().pressure_at_nodes(state.p);
  for (const MeshPlace& at : probes_) {
    sums.probes.push_back({.pressure = at.of(pressure, 1, 0),
                           .stream = at.of(psi, 1, 0),
                           .velocity = {at.of(state.v, 2, 0), at.of(state.v, 2, 1)}});
  }
  for (const auto& [first, second] : flow_.differences)
    sums.differences.push_back(sums.probes[at(first)].pressure - sums.probes[at(second)].pressure);
}

void FlowFields::add_bodies(const FlowState& state, FlowSums& sums) const {
  const ImmersedSolids& immersed = *step_.immersed();
  const auto& regions = immersed.solids().regions;
  for (std::size_t r = 0; r < regions.size(); ++r) {
    const auto& parts = body_volumes_[r];
    const double mass = regions[r].density * std::accumulate(parts.begin(), parts.end(), 0.0);
    sums.bodies.push_back(body_of(mass, parts, state.q, state.w, 2));
    sums.on_bodies.push_back(body_force(state.body_forces, r));
  }
  sums.tracked = tracked_of(immersed.solids(), state.q, state.w);
  if (flow_.tracers.count[0] > 0)
    sums.tracers_inside = static_cast<double>(tracers_.count_inside(immersed.solids(), state));
  const ShapeVolumes shape = immersed.system().elements->shape(state.q);
  sums.least = shape.least, sums.volumes = shape.of_region;
  sums.nodes_inside = static_cast<double>(state.overlap.now);
}

FlowSums FlowFields::sums_of(const FlowState& state) const {
  const FlowElements& elements = step_.elements();
  const ImmersedSolids* immersed = step_.immersed();
  FlowSums s;
  s.time = state.time, s.dt = state.dt_last;
  s.kinetic = elements.kinetic_energy(state.v) + (immersed ? immersed->kinetic_energy(state) : 0);
  s.strain = immersed ? immersed->strain_energy(state) : 0;
  s.potential = immersed ? immersed->potential_energy(state) : 0;
  s.contact = state.contact;
  s.total = s.kinetic + s.strain + s.potential + s.contact.last.energy;
  s.exchanged = state.exchanged, s.pressure_energy = elements.pressure_energy(state.p);
  const auto momentum = elements.momentum(state.v);
  s.mass = momentum[0], s.momentum = {momentum[1], momentum[2]};
  const std::vector<double> psi = stream_.of(state.v);
  const auto [least, largest] = std::minmax_element(psi.begin(), psi.end());
  s.least_stream = *least, s.most_stream = *largest;
  s.reynolds = flow_.density * flow_.speed * flow_.length / step_.viscosity();
  s.forces = forces_.of(state, last_moment(state));
  s.unit_force = 0.5 * flow_.density * flow_.speed * flow_.speed * flow_.length;
  add_probes(state, psi, s);
  if (immersed) add_bodies(state, s);
  return s;
}

Snapshot FlowFields::body_fields(const FlowState& state) const {
  if (!step_.immersed()) return {state.time, {}};
  const SolidSystem& system = step_.immersed()->system();
  return shape_fields(state.time, system.solids.mesh, *system.elements, state.q, state.w,
                      step_.immersed()->meets() ? &state.contact.last : nullptr);
}

Snapshot FlowFields::node_fields(const FlowState& state) const {
  const NodeSource source{flow_.mesh, state, step_.elements().pressure_at_nodes(state.p), stream_.of(state.v),
                          step_.elements().vorticity(state.v)};
  return Columns<NodeSource>(node_table(), ColumnSetting{}).snapshot(state.time, flow_.mesh.node_count(), source);
}

}  // namespace tether::fem
