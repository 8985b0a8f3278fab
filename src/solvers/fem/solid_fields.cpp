// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/fem/solid_fields.hpp"

#include <fmt/format.h>

#include <numeric>

namespace tether::fem {
namespace {

Components node_vector(std::span<const double> q, std::size_t node, int dim) {
  Components v{};
  for (int i = 0; i < dim; ++i)
    v[static_cast<std::size_t>(i)] = q[node * static_cast<std::size_t>(dim) + static_cast<std::size_t>(i)];
  return v;
}

/// Sums over all nodes with their momenta M v: m v, and x cross m v.
void add_motion(const SolidState& state, const SolidSystem& system, const std::vector<double>& momenta, SolidSums& s) {
  for (std::size_t n = 0; n < system.weights.size(); ++n) {
    const auto x = node_vector(state.q, n, system.dim()), p = node_vector(momenta, n, system.dim());
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      s.momentum[i] += p[i], s.angular[i] += x[j] * p[k] - x[k] * p[j];
    }
  }
}

ColumnGroup<ColumnSetting, SolidSums> work_columns() {
  using Row = Column<ColumnSetting, SolidSums>;
  using D = Dimension;
  return {{Row("energy_loads", D::energy, "work that loads have done on the bodies", &SolidSums::of_loads)
               .booked(Book::gained),
           Row("energy_supports", D::energy, "work of supports and walls that move", &SolidSums::of_supports)
               .booked(Book::gained),
           Row("energy_damped", D::energy, "energy that damping has taken", &SolidSums::damped).booked(Book::given)}};
}

/// M v, by the masses that the integrator moves.
std::vector<double> momenta_of(const SolidState& state, const SolidSystem& system) {
  const auto d = static_cast<std::size_t>(system.dim());
  std::vector<double> momenta(state.v.size());
  if (system.solids.integrator == Integrator::central) {
    for (std::size_t k = 0; k < momenta.size(); ++k) momenta[k] = system.lumped[k / d] * state.v[k];
  } else {
    system.multiply_mass(state.v, momenta);
  }
  return momenta;
}

}  // namespace

const ColumnTable<ColumnSetting, SolidSums>& solid_table() {
  static const ColumnTable<ColumnSetting, SolidSums> table(
      {energy_columns(), work_columns(), momentum_columns(), given(in_space(), spin_columns()),
       given(in_plane(), plane_spin_column()), overlap_columns(), shape_columns(), body_columns(), tracked_columns()});
  return table;
}

Columns<SolidSums> solid_columns(const Solids& solids) {
  return {solid_table(), mesh_setting(solids, region_names(solids))};
}

SolidSums sums_of(const SolidState& state, const SolidSystem& system) {
  const std::vector<double> momenta = momenta_of(state, system);
  SolidSums s;
  s.time = state.time, s.dt = state.dt_last;
  for (std::size_t k = 0; k < momenta.size(); ++k) s.kinetic += 0.5 * momenta[k] * state.v[k];
  s.strain = system.elements->strain_energy(state.q), s.potential = system.gravity_energy(state.q);
  s.total = s.kinetic + s.strain + s.potential;
  s.of_loads = state.of_loads, s.of_supports = state.of_supports, s.damped = state.damped;
  for (const auto& weights : system.region_weights) {
    const double mass = std::accumulate(weights.begin(), weights.end(), 0.0);
    s.bodies.push_back(body_of(mass, weights, state.q, state.v, static_cast<std::size_t>(system.dim())));
    s.mass += mass;
  }
  add_motion(state, system, momenta, s);
  s.nodes_inside = static_cast<double>(state.overlap.now);
  const ShapeVolumes shape = system.elements->shape(state.q);
  s.least = shape.least, s.volumes = shape.of_region;
  s.tracked = tracked_of(system.solids, state.q, state.v);
  return s;
}

std::string worst_element(const SolidSystem& system, std::span<const double> q) {
  const ShapeVolumes shape = system.elements->shape(q);
  const auto x = node_vector(q, static_cast<std::size_t>(system.solids.mesh.element(shape.worst)[0]), system.dim());
  return fmt::format("element {} at ({:.6g}, {:.6g}{})", shape.worst + 1, x[0], x[1],
                     system.dim() == 3 ? fmt::format(", {:.6g}", x[2]) : "");
}

Snapshot node_fields(const SolidState& state, const SolidSystem& system) {
  return shape_fields(state.time, system.solids.mesh, *system.elements, state.q, state.v);
}

}  // namespace tether::fem
