// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/solids/system.hpp"

#include <algorithm>

#include "base/vec.hpp"
#include "physics/solids/make_elements.hpp"

namespace tether::fem {
namespace {

/// <rho N_A> of each region; central differences move lumped masses instead, of which a region has the same share.
std::vector<std::vector<double>> masses_of_regions(const SolidSystem& system) {
  std::vector<std::vector<double>> all;
  const bool lumped = system.solids.integrator == Integrator::central;
  for (std::size_t r = 0; r < system.solids.regions.size(); ++r) {
    std::vector<double> masses = system.elements->volumes(static_cast<int>(r));
    for (std::size_t n = 0; n < masses.size(); ++n) {
      masses[n] *= system.solids.regions[r].density;
      if (lumped && system.weights[n] != 0) masses[n] *= system.lumped[n] / system.weights[n];
    }
    all.push_back(std::move(masses));
  }
  return all;
}

}  // namespace

SolidSystem::SolidSystem(const Solids& of, double gravity, Team& team)
    : solids(of),
      elements(make_elements(of, team)),
      pattern(of.mesh.dim(), of.mesh.node_count(), of.mesh.nodes, node_count_of(of.mesh.kind)),
      mass(elements->mass()),
      lumped(elements->lumped_mass()),
      weights(of.mesh.node_count()),
      held(of.mesh.x.size(), 0),
      gravity_(gravity) {
  mass.multiply(std::vector<double>(weights.size(), 1.0), weights);
  region_weights = masses_of_regions(*this);
  for (const Load& load : solids.loads) {
    loads_.push_back({load.region < 0 ? side_areas(solids.mesh, load.sides) : elements->volumes(load.region), &load});
  }
  const auto d = static_cast<std::size_t>(dim());
  for (const Support& support : solids.supports) {
    for (const int node : support.nodes) {
      for (std::size_t i = 0; i < d; ++i) held[at(node) * d + i] = support.fixed[i] ? 1 : held[at(node) * d + i];
    }
  }
}

void SolidSystem::multiply_mass(std::span<const double> v, std::span<double> y) const {
  const auto d = static_cast<std::size_t>(dim());
  std::fill(y.begin(), y.end(), 0.0);
  for (std::size_t b = 0; b < weights.size(); ++b) {
    for (auto k = static_cast<std::size_t>(mass.start[b]); k < static_cast<std::size_t>(mass.start[b + 1]); ++k) {
      const auto a = static_cast<std::size_t>(mass.row[k]);
      for (std::size_t i = 0; i < d; ++i) y[a * d + i] += mass.value[k] * v[b * d + i];
    }
  }
}

void SolidSystem::external_forces(double time, std::span<double> f) const {
  const auto d = static_cast<std::size_t>(dim());
  for (std::size_t a = 0; a < weights.size(); ++a) {
    for (std::size_t i = 0; i < d; ++i) f[a * d + i] = i == 1 ? gravity_ * weights[a] : 0;
  }
  for (const NodalLoad& load : loads_) {
    const double factor = load.load->amplitude.at(time);
    for (std::size_t a = 0; a < load.parts.size(); ++a) {
      for (std::size_t i = 0; i < d; ++i) f[a * d + i] += factor * load.parts[a] * load.load->force[i];
    }
  }
}

double SolidSystem::gravity_energy(std::span<const double> q) const {
  const auto d = static_cast<std::size_t>(dim());
  double energy = 0;
  for (std::size_t a = 0; a < weights.size(); ++a) energy -= gravity_ * weights[a] * q[a * d + 1];
  return energy;
}

void SolidSystem::place_supports(double time, std::span<double> q) const {
  const auto d = static_cast<std::size_t>(dim());
  for (const Support& support : solids.supports) {
    const double factor = support.amplitude.at(time);
    for (const int node : support.nodes) {
      const std::size_t first = static_cast<std::size_t>(node) * d;
      for (std::size_t i = 0; i < d; ++i) {
        if (support.fixed[i]) q[first + i] = solids.mesh.x[first + i] + factor * support.displacement[i];
      }
    }
  }
}

void SolidSystem::move_supports(double time, double h, std::span<double> v) const {
  const auto d = static_cast<std::size_t>(dim());
  const double from = std::max(0.0, time - h), to = time + h;
  for (const Support& support : solids.supports) {
    const double slope = (support.amplitude.at(to) - support.amplitude.at(from)) / (to - from);
    for (const int node : support.nodes) {
      for (std::size_t i = 0; i < d; ++i) {
        if (support.fixed[i]) v[static_cast<std::size_t>(node) * d + i] = slope * support.displacement[i];
      }
    }
  }
}

std::vector<double> first_velocities(const SolidSystem& system) {
  const Solids& solids = system.solids;
  const auto d = static_cast<std::size_t>(system.dim());
  std::vector<double> v(system.unknowns(), 0.0), mass(system.lumped.size(), 0.0);
  for (std::size_t r = 0; r < solids.regions.size(); ++r) {
    const SolidRegion& region = solids.regions[r];
    const std::vector<double>& weights = system.region_weights[r];
    Vec<3> centre{};
    double total = 0;
    for (std::size_t n = 0; n < weights.size(); ++n) {
      total += weights[n];
      for (std::size_t i = 0; i < d; ++i) centre[i] += weights[n] * solids.mesh.x[n * d + i];
    }
    for (std::size_t n = 0; n < weights.size(); ++n) {
      Vec<3> arm{};
      for (std::size_t i = 0; i < d; ++i) arm[i] = solids.mesh.x[n * d + i] - centre[i] / total;
      const double m = weights[n];
      mass[n] += m;
      for (std::size_t i = 0; i < d; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        v[n * d + i] += m * (region.velocity[i] + region.spin[j] * arm[k] - region.spin[k] * arm[j]);
      }
    }
  }
  for (std::size_t k = 0; k < v.size(); ++k) v[k] = system.held[k] || mass[k / d] == 0 ? 0 : v[k] / mass[k / d];
  return v;
}

}  // namespace tether::fem
