// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/fem/solid_fields.hpp"

#include <fmt/format.h>

#include <array>
#include <numeric>

#include "solvers/fem/mesh_fields.hpp"

namespace tether::fem {
namespace {

/// Sums over all nodes with the consistent mass: m v, and x cross m v.
struct Motion {
  std::array<double, 3> momentum{}, angular{};
};

std::array<double, 3> node_vector(std::span<const double> q, std::size_t node, int dim) {
  std::array<double, 3> v{};
  for (int i = 0; i < dim; ++i)
    v[static_cast<std::size_t>(i)] = q[node * static_cast<std::size_t>(dim) + static_cast<std::size_t>(i)];
  return v;
}

/// Of all nodes, with their momenta M v.
Motion motion_of(const SolidState& state, const SolidSystem& system, const std::vector<double>& momenta) {
  Motion motion;
  for (std::size_t n = 0; n < system.weights.size(); ++n) {
    const auto x = node_vector(state.q, n, system.dim()), p = node_vector(momenta, n, system.dim());
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      motion.momentum[i] += p[i], motion.angular[i] += x[j] * p[k] - x[k] * p[j];
    }
  }
  return motion;
}

/// Adds the mean of each component over each region's mass: its centre, or that centre's velocity.
void add_means(const std::vector<double>& values, const SolidSystem& system, const std::vector<double>& masses,
               Record& record) {
  const auto d = static_cast<std::size_t>(system.dim());
  for (std::size_t i = 0; i < d; ++i) {
    for (std::size_t r = 0; r < masses.size(); ++r) {
      double sum = 0;
      for (std::size_t n = 0; n < system.weights.size(); ++n) sum += system.region_weights[r][n] * values[n * d + i];
      record.push_back(sum / masses[r]);
    }
  }
}

}  // namespace

HistoryLayout history_layout(const Solids& solids) {
  HistoryLayout layout;
  add_energies(layout);
  layout.quantities.push_back(
      {"energy_loads", Dimension::energy, "work that loads have done on the solids", Per::scene, Book::gained});
  layout.quantities.push_back(
      {"energy_supports", Dimension::energy, "work of supports and walls that move", Per::scene, Book::gained});
  layout.quantities.push_back(
      {"energy_damped", Dimension::energy, "energy that damping has taken", Per::scene, Book::given});
  add_momenta(layout, solids.mesh.dim());
  add_overlap(layout);
  add_shape(layout);
  std::vector<std::string> names;
  for (const SolidRegion& region : solids.regions) names.push_back(region.name);
  add_bodies_and_nodes(layout, solids, names);
  return layout;
}

Record record(const SolidState& state, const SolidSystem& system) {
  const int dim = system.dim();
  const auto d = static_cast<std::size_t>(dim);
  std::vector<double> momenta(state.v.size());
  const bool lumped = system.solids.integrator == Integrator::central;
  if (lumped) {
    for (std::size_t k = 0; k < momenta.size(); ++k) momenta[k] = system.lumped[k / d] * state.v[k];
  } else {
    system.multiply_mass(state.v, momenta);
  }
  const Motion motion = motion_of(state, system, momenta);
  std::vector<double> masses;
  for (const auto& weights : system.region_weights)
    masses.push_back(std::accumulate(weights.begin(), weights.end(), 0.0));
  double kinetic = 0;
  for (std::size_t k = 0; k < momenta.size(); ++k) kinetic += 0.5 * momenta[k] * state.v[k];
  const double strain = system.elements->strain_energy(state.q), potential = system.gravity_energy(state.q);
  Record values{state.time,
                state.dt_last,
                kinetic,
                strain,
                0,
                potential,
                kinetic + strain + potential,
                state.of_loads,
                state.of_supports,
                state.damped,
                std::accumulate(masses.begin(), masses.end(), 0.0)};
  values.insert(values.end(), motion.momentum.begin(), motion.momentum.begin() + dim);
  values.insert(values.end(), motion.angular.begin() + (dim == 3 ? 0 : 2), motion.angular.end());
  values.push_back(static_cast<double>(state.overlap.now));
  const ShapeVolumes shape = system.elements->shape(state.q);
  values.push_back(shape.least);
  values.insert(values.end(), shape.of_region.begin(), shape.of_region.end());
  add_means(state.q, system, masses, values);
  add_means(state.v, system, masses, values);
  values.insert(values.end(), masses.begin(), masses.end());
  append_tracked(system.solids, state.q, state.v, values);
  return values;
}

std::string worst_element(const SolidSystem& system, std::span<const double> q) {
  const ShapeVolumes shape = system.elements->shape(q);
  const auto x = node_vector(q, static_cast<std::size_t>(system.solids.mesh.element(shape.worst)[0]), system.dim());
  return fmt::format("element {} at ({:.6g}, {:.6g}{})", shape.worst + 1, x[0], x[1],
                     system.dim() == 3 ? fmt::format(", {:.6g}", x[2]) : "");
}

Snapshot node_fields(const SolidState& state, const SolidSystem& system) {
  return shape_fields(state.time, system, state.q, state.v);
}

Snapshot shape_fields(double time, const SolidSystem& system, std::span<const double> q, std::span<const double> v) {
  const auto d = static_cast<std::size_t>(system.dim());
  const std::size_t nodes = system.lumped.size();
  Snapshot snapshot = motion_fields(time, system.solids.mesh, q, v);
  const std::vector<double> stress = system.elements->nodal_stress(q);
  constexpr std::array names{"sxx", "syy", "szz", "sxy", "syz", "sxz", "energy_density"};
  for (std::size_t f = 0; f < names.size(); ++f) {
    if (d == 2 && (f == 4 || f == 5)) continue;
    Field field{{names[f], Dimension::stress,
                 f == 6 ? "strain energy per volume of the shape at the start" : "Cauchy's stress"},
                std::vector<double>(nodes)};
    for (std::size_t n = 0; n < nodes; ++n) field.values[n] = stress[n * names.size() + f];
    snapshot.fields.push_back(std::move(field));
  }
  return snapshot;
}

}  // namespace tether::fem
