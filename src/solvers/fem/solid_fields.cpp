// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/fem/solid_fields.hpp"

#include <fmt/format.h>

#include <array>
#include <numeric>

namespace tether::fem {
namespace {

constexpr std::array axes{"x", "y", "z"};

void add_vector(HistoryLayout& layout, const std::string& name, Dimension dimension, const std::string& meaning,
                int dim, Per per) {
  for (int i = 0; i < dim; ++i) {
    const std::string axis = axes[static_cast<std::size_t>(i)];
    layout.quantities.push_back({name + axis, dimension, meaning + axis, per});
  }
}

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
  const int dim = solids.mesh.dim();
  HistoryLayout layout;
  layout.quantities = {
      {"time", Dimension::time, "time"},
      {"dt", Dimension::time, "length of the last step"},
      {"energy_kinetic", Dimension::energy, "kinetic energy"},
      {"energy_strain", Dimension::energy, "energy stored in solids"},
      {"energy_internal", Dimension::energy, "internal energy of gas: none"},
      {"energy_potential", Dimension::energy, "potential energy in gravity, zero at y = 0"},
      {"energy_total", Dimension::energy, "sum of the energies"},
      {"energy_outside", Dimension::energy, "work that loads and moved supports have done on the solids"},
      {"energy_damped", Dimension::energy, "energy that damping has taken"},
      {"mass", Dimension::mass, "mass"},
  };
  add_vector(layout, "momentum_", Dimension::momentum, "momentum in ", dim, Per::scene);
  if (dim == 3) {
    add_vector(layout, "angular_momentum_", Dimension::angular_momentum, "angular momentum about the origin, ", 3,
               Per::scene);
  } else {
    layout.quantities.push_back(
        {"angular_momentum_z", Dimension::angular_momentum, "angular momentum about the origin"});
  }
  add_vector(layout, "body_", Dimension::length, "centre of mass, ", dim, Per::body);
  add_vector(layout, "body_v", Dimension::velocity, "velocity of the centre of mass, ", dim, Per::body);
  layout.quantities.push_back({"body_mass", Dimension::mass, "mass", Per::body});
  if (!solids.tracked.empty()) {
    add_vector(layout, "point_", Dimension::length, "place, ", dim, Per::point);
    add_vector(layout, "point_v", Dimension::velocity, "velocity, ", dim, Per::point);
  }
  for (const SolidRegion& region : solids.regions) layout.body_names.push_back(region.name);
  for (const int node : solids.tracked) layout.point_names.push_back(fmt::format("node {}", node + 1));
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
                state.work,
                state.damped,
                std::accumulate(masses.begin(), masses.end(), 0.0)};
  values.insert(values.end(), motion.momentum.begin(), motion.momentum.begin() + dim);
  values.insert(values.end(), motion.angular.begin() + (dim == 3 ? 0 : 2), motion.angular.end());
  add_means(state.q, system, masses, values);
  add_means(state.v, system, masses, values);
  values.insert(values.end(), masses.begin(), masses.end());
  for (std::size_t i = 0; i < d; ++i) {
    for (const int node : system.solids.tracked) values.push_back(state.q[static_cast<std::size_t>(node) * d + i]);
  }
  for (std::size_t i = 0; i < d; ++i) {
    for (const int node : system.solids.tracked) values.push_back(state.v[static_cast<std::size_t>(node) * d + i]);
  }
  return values;
}

Snapshot node_fields(const SolidState& state, const SolidSystem& system) {
  const auto d = static_cast<std::size_t>(system.dim());
  const std::size_t nodes = system.lumped.size();
  Snapshot snapshot;
  snapshot.time = state.time;
  const auto add = [&](const std::string& name, Dimension dimension, const std::string& meaning, auto value) {
    Field field{{name, dimension, meaning}, std::vector<double>(nodes)};
    for (std::size_t n = 0; n < nodes; ++n) field.values[n] = value(n);
    snapshot.fields.push_back(std::move(field));
  };
  for (std::size_t i = 0; i < d; ++i)
    add(axes[i], Dimension::length, "place", [&](std::size_t n) { return state.q[n * d + i]; });
  for (std::size_t i = 0; i < d; ++i) {
    add(std::string("u") + axes[i], Dimension::length, "displacement",
        [&](std::size_t n) { return state.q[n * d + i] - system.solids.mesh.x[n * d + i]; });
  }
  for (std::size_t i = 0; i < d; ++i)
    add(std::string("v") + axes[i], Dimension::velocity, "velocity", [&](std::size_t n) { return state.v[n * d + i]; });
  const std::vector<double> stress = system.elements->nodal_stress(state.q);
  constexpr std::array names{"sxx", "syy", "szz", "sxy", "syz", "sxz", "energy_density"};
  for (std::size_t f = 0; f < names.size(); ++f) {
    if (d == 2 && (f == 2 || f == 4 || f == 5)) continue;
    add(names[f], Dimension::stress, f == 6 ? "strain energy per volume of the shape at the start" : "Cauchy's stress",
        [&](std::size_t n) { return stress[n * names.size() + f]; });
  }
  return snapshot;
}

}  // namespace tether::fem
