// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/fem/flow_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "grid/point_finder.hpp"
#include "solvers/fem/mesh_fields.hpp"
#include "solvers/fem/solid_fields.hpp"

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

/// What a flow of this kind exchanges; a steady one exchanges over no time, and nothing is booked.
std::vector<ExchangeColumn> exchanges_of(const Flow& flow, bool with_bodies) {
  using All = FlowExchange;
  if (flow.integrator == FlowIntegrator::steady) return {};
  std::vector<ExchangeColumn> list{
      {"energy_walls", "work of moving walls on the fluid", Book::gained, &All::walls},
      {"energy_inflow", "work of inflows, and the kinetic energy that they bring", Book::gained, &All::inflows},
      {"energy_open", "work at open sides, less the kinetic energy that leaves there", Book::gained, &All::open},
      {"energy_body_forces", "work of gravity and body forces on the fluid", Book::gained, &All::body_forces}};
  if (with_bodies) {
    list.push_back({"energy_loads", "work of loads on bodies", Book::gained, &All::loads});
    list.push_back({"energy_supports", "work of bodies' supports", Book::gained, &All::supports});
  }
  list.push_back({"energy_viscous", "energy that viscosity turned into heat", Book::given, &All::viscosity});
  if (flow.element == FlowElement::q1q1)
    list.push_back({"energy_stabilised", "energy lost to what stabilises equal orders of velocity and pressure",
                    Book::lost, &All::stabilised});
  list.push_back({"energy_advected", "energy lost by advection where velocities are not quite free of divergence",
                  Book::lost, &All::advected});
  if (with_bodies)
    list.push_back({"energy_immersed",
                    "energy lost in bodies by their steps and as they take the fluid's velocity anew", Book::lost,
                    &All::immersed});
  if (flow.integrator == FlowIntegrator::euler)
    list.push_back(
        {"energy_stepped", "kinetic energy of the fluid lost by steps of backward Euler", Book::lost, &All::stepped});
  return list;
}

/// Whether drag and lift are wanted as coefficients.
bool has_coefficients(const Flow& flow) { return flow.speed > 0 && flow.length > 0; }

}  // namespace

FlowFields::FlowFields(const Flow& flow, const FlowStep& step, const FlowTracers& tracers)
    : flow_(flow),
      step_(step),
      tracers_(tracers),
      stream_(step.elements()),
      forces_(flow, step),
      exchanges_(exchanges_of(flow, step.immersed() != nullptr)) {
  const PointFinder finder(flow.mesh);
  for (const auto& probe : flow.probes) probes_.push_back(place_of(flow.mesh, finder.find(probe).value()));
  if (!step.immersed()) return;
  for (std::size_t r = 0; r < step.immersed()->solids().regions.size(); ++r)
    body_volumes_.push_back(step.immersed()->system().elements->volumes(static_cast<int>(r)));
}

HistoryLayout FlowFields::history_layout() const {
  HistoryLayout layout;
  add_energies(layout);
  const auto add = [&](const std::string& name, Dimension dimension, const std::string& meaning,
                       Book book = Book::none) {
    layout.quantities.push_back({name, dimension, meaning, Per::scene, book});
  };
  for (const ExchangeColumn& exchange : exchanges_)
    add(exchange.name, Dimension::energy, exchange.meaning, exchange.book);
  add("energy_pressure", Dimension::energy, "size of the pressure times volume: rounding at rest is small against it");
  add("mass", Dimension::mass, "mass of the fluid, and of as much of it as solids are in the place of");
  add("momentum_x", Dimension::momentum, "momentum of the same in x");
  add("momentum_y", Dimension::momentum, "momentum of the same in y");
  add("stream_min", Dimension::flux, "least value of the stream function at a node");
  add("stream_max", Dimension::flux, "largest value of the stream function at a node");
  if (has_coefficients(flow_)) add("reynolds", Dimension::number, "Reynolds number by speed and length of the deck");
  forces_.add_columns(layout);
  for (std::size_t k = 0; k < flow_.probes.size(); ++k) {
    const std::string number = fmt::format("_{}", k + 1);
    add("probe_p" + number, Dimension::stress, "pressure at the probe, of the last step");
    add("probe_vx" + number, Dimension::velocity, "velocity in x there");
    add("probe_vy" + number, Dimension::velocity, "velocity in y there");
    add("probe_stream" + number, Dimension::flux, "stream function there");
  }
  for (std::size_t k = 0; k < flow_.differences.size(); ++k)
    add(fmt::format("pressure_difference_{}", k + 1), Dimension::stress,
        fmt::format("pressure at probe {} less that at probe {}", flow_.differences[k][0] + 1,
                    flow_.differences[k][1] + 1));
  if (!step_.immersed()) return layout;
  std::vector<std::string> names;
  for (const SolidRegion& region : step_.immersed()->solids().regions) names.push_back(region.name);
  FlowForces::add_body_columns(layout);
  add_bodies_and_nodes(layout, step_.immersed()->solids(), names);
  if (flow_.tracers.count[0] > 0)
    add("tracers_in_solids", Dimension::number, "tracers inside of solids, which start outside");
  add_shape(layout);
  add_overlap(layout);
  return layout;
}

/// What the last step was about, of a state that a checkpoint held, too.
FlowMoment FlowFields::last_moment(const FlowState& state) const {
  return {.v0 = state.v_before,
          .v1 = state.v,
          .p = state.p,
          .theta = flow_.integrator == FlowIntegrator::midpoint ? 0.5 : 1,
          .viscosity = step_.viscosity(),
          .acceleration = {}};
}

void FlowFields::append_probes(const FlowState& state, const std::vector<double>& pressure,
                               const std::vector<double>& psi, Record& record) const {
  for (const MeshPlace& at : probes_)
    record.insert(record.end(), {at.of(pressure, 1, 0), at.of(state.v, 2, 0), at.of(state.v, 2, 1), at.of(psi, 1, 0)});
  for (const auto& [first, second] : flow_.differences)
    record.push_back(probes_[static_cast<std::size_t>(first)].of(pressure, 1, 0) -
                     probes_[static_cast<std::size_t>(second)].of(pressure, 1, 0));
}

/// As add_body_columns(), add_bodies_and_nodes() and the volume list them.
void FlowFields::append_bodies(const FlowState& state, Record& record) const {
  const ImmersedSolids& immersed = *step_.immersed();
  const auto& regions = immersed.solids().regions;
  forces_.append_bodies(state, record);
  std::vector<double> sizes;
  for (const auto& volumes : body_volumes_) sizes.push_back(std::accumulate(volumes.begin(), volumes.end(), 0.0));
  for (const auto* values : {&state.q, &state.w}) {
    for (std::size_t i = 0; i < 2; ++i) {
      for (std::size_t r = 0; r < regions.size(); ++r) {
        double sum = 0;
        for (std::size_t n = 0; n < body_volumes_[r].size(); ++n) sum += body_volumes_[r][n] * (*values)[2 * n + i];
        record.push_back(sum / sizes[r]);
      }
    }
  }
  for (std::size_t r = 0; r < regions.size(); ++r) record.push_back(regions[r].density * sizes[r]);
  append_tracked(immersed.solids(), state.q, state.w, record);
  if (flow_.tracers.count[0] > 0)
    record.push_back(static_cast<double>(tracers_.count_inside(immersed.solids(), state)));
  const ShapeVolumes shape = immersed.system().elements->shape(state.q);
  record.push_back(shape.least);
  record.insert(record.end(), shape.of_region.begin(), shape.of_region.end());
  record.push_back(static_cast<double>(state.overlap.now));
}

Snapshot FlowFields::body_fields(const FlowState& state) const {
  if (!step_.immersed()) return {state.time, {}};
  return shape_fields(state.time, step_.immersed()->system(), state.q, state.w);
}

Record FlowFields::record(const FlowState& state) const {
  const FlowElements& elements = step_.elements();
  const auto momentum = elements.momentum(state.v);
  const ImmersedSolids* immersed = step_.immersed();
  const double kinetic = elements.kinetic_energy(state.v) + (immersed ? immersed->kinetic_energy(state) : 0);
  const double strain = immersed ? immersed->strain_energy(state) : 0;
  const double potential = immersed ? immersed->potential_energy(state) : 0;
  const std::vector<double> psi = stream_.of(state.v), pressure = elements.pressure_at_nodes(state.p);
  const auto [least, largest] = std::minmax_element(psi.begin(), psi.end());
  Record values{
      state.time, state.dt_last, kinetic, strain, 0, potential, kinetic + strain + potential,
  };
  for (const ExchangeColumn& exchange : exchanges_) values.push_back(state.exchanged.*exchange.amount);
  values.insert(values.end(),
                {elements.pressure_energy(state.p), momentum[0], momentum[1], momentum[2], *least, *largest});
  if (has_coefficients(flow_)) values.push_back(flow_.density * flow_.speed * flow_.length / step_.viscosity());
  forces_.append(state, last_moment(state), values);
  append_probes(state, pressure, psi, values);
  if (immersed) append_bodies(state, values);
  return values;
}

Snapshot FlowFields::node_fields(const FlowState& state) const {
  const Mesh& mesh = flow_.mesh;
  Snapshot snapshot;
  snapshot.time = state.time;
  const auto add = [&](const char* name, Dimension dimension, const char* meaning, std::vector<double> values) {
    snapshot.fields.push_back({{name, dimension, meaning}, std::move(values)});
  };
  const auto part = [&](const std::vector<double>& pairs, std::size_t i) {
    std::vector<double> values(mesh.node_count());
    for (std::size_t n = 0; n < values.size(); ++n) values[n] = pairs[2 * n + i];
    return values;
  };
  add("x", Dimension::length, "place", part(mesh.x, 0));
  add("y", Dimension::length, "place", part(mesh.x, 1));
  add("vx", Dimension::velocity, "velocity in x", part(state.v, 0));
  add("vy", Dimension::velocity, "velocity in y", part(state.v, 1));
  add("p", Dimension::stress, "pressure, of the last step", step_.elements().pressure_at_nodes(state.p));
  add("stream", Dimension::flux, "stream function, zero at the first node", stream_.of(state.v));
  add("vorticity", Dimension::rate, "dv/dx - du/dy, the mean around each node", step_.elements().vorticity(state.v));
  return snapshot;
}

}  // namespace tether::fem
