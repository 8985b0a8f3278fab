// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/solids/system.hpp"

#include <algorithm>

#include "base/vec.hpp"
#include "physics/solids/make_elements.hpp"

namespace tether::fem {
namespace {

/// <rho N_A> of each region; central differences move lumped masses instead.
std::vector<std::vector<double>> masses_of_regions(const SolidSystem& system) {
  if (system.solids.integrator == Integrator::central) return system.region_lumped;
  std::vector<std::vector<double>> all;
  for (std::size_t r = 0; r < system.solids.regions.size(); ++r) {
    std::vector<double> masses = system.elements->volumes(static_cast<int>(r));
    for (double& mass : masses) mass *= system.solids.regions[r].density;
    all.push_back(std::move(masses));
  }
  return all;
}

}  // namespace

SolidSystem::SolidSystem(const Solids& of, const Vec<3>& gravity, Team& team)
    : solids(of),
      elements(make_elements(of, team)),
      pattern(of.mesh.dim(), of.mesh.node_count(), of.mesh.nodes, node_count_of(of.mesh.kind)),
      mass(elements->mass()),
      weights(of.mesh.node_count()),
      lumped(of.mesh.node_count(), 0.0),
      held(of.mesh.x.size(), 0),
      holder(of.mesh.x.size(), -1),
      team_(team),
      gravity_(gravity) {
  mass.multiply(std::vector<double>(weights.size(), 1.0), weights);
  for (std::size_t r = 0; r < solids.regions.size(); ++r) {
    region_lumped.push_back(elements->lumped_volumes(static_cast<int>(r)));
    for (std::size_t n = 0; n < lumped.size(); ++n) lumped[n] += region_lumped[r][n] *= solids.regions[r].density;
  }
  region_weights = masses_of_regions(*this);
  for (const Load& load : solids.loads) {
    if (load.is_dead()) loads_.push_back({load_parts(load, solids.mesh, *elements), &load});
    if (load.pressure != 0) pressures_.push_back({SidePressure(solids.mesh, load.sides), &load});
  }
  const auto d = static_cast<std::size_t>(dim());
  for (std::size_t s = 0; s < solids.supports.size(); ++s) {
    for (const int node : solids.supports[s].nodes) {
      for (std::size_t i = 0; i < d; ++i) {
        if (solids.supports[s].fixed[i]) held[at(node) * d + i] = 1, holder[at(node) * d + i] = static_cast<int>(s);
      }
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

/// A column's rows stand in the matrix node by node, dim each.
void SolidSystem::add_mass(double factor, SparseMatrix& matrix) const {
  const SparseMatrix& M = mass;
  const std::int64_t d = dim();
  for (std::int64_t node = 0; node < M.n; ++node) {
    for (std::int64_t i = 0; i < d; ++i) {
      const std::int64_t first = matrix.start[static_cast<std::size_t>(d * node + i)];
      for (std::int64_t k = M.start[static_cast<std::size_t>(node)]; k < M.start[static_cast<std::size_t>(node + 1)];
           ++k) {
        const std::int64_t rank = k - M.start[static_cast<std::size_t>(node)];
        matrix.value[static_cast<std::size_t>(first + d * rank + i)] += factor * M.value[static_cast<std::size_t>(k)];
      }
    }
  }
}

void SolidSystem::external_forces(double time, std::span<double> f) const {
  const auto d = static_cast<std::size_t>(dim());
  for (std::size_t a = 0; a < weights.size(); ++a) {
    for (std::size_t i = 0; i < d; ++i) f[a * d + i] = gravity_[i] * weights[a];
  }
  for (const NodalLoad& load : loads_) {
    const double factor = load.load->amplitude.at(time);
    for (std::size_t a = 0; a < load.parts.size(); ++a) {
      for (std::size_t i = 0; i < d; ++i) f[a * d + i] += factor * load.parts[a] * load.load->force[i];
    }
  }
}

void SolidSystem::add_pressures(double time, StressAt at, std::span<const double> q0, std::span<const double> q1,
                                std::span<double> f, double factor) const {
  for (const FollowingLoad& load : pressures_)
    load.of.add_forces(at, q0, q1, factor * load.load->amplitude.at(time) * load.load->pressure, f);
}

void SolidSystem::add_pressure_tangent(double time, StressAt at, std::span<const double> q0, std::span<const double> q1,
                                       double factor, SparseMatrix& K) const {
  for (const FollowingLoad& load : pressures_)
    load.of.add_tangent(at, q0, q1, factor * load.load->amplitude.at(time) * load.load->pressure, pattern, K);
}

double SolidSystem::gravity() const { return std::sqrt(dot(gravity_, gravity_)); }

double SolidSystem::gravity_energy(std::span<const double> q) const {
  const auto d = static_cast<std::size_t>(dim());
  double energy = 0;
  for (std::size_t a = 0; a < weights.size(); ++a) {
    for (std::size_t i = 0; i < d; ++i) energy -= gravity_[i] * weights[a] * q[a * d + i];
  }
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
  std::vector<double> v(system.unknowns(), 0.0);
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
      const double m = system.region_lumped[r][n];
      for (std::size_t i = 0; i < d; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        v[n * d + i] += m * (region.velocity[i] + region.spin[j] * arm[k] - region.spin[k] * arm[j]);
      }
    }
  }
  for (std::size_t k = 0; k < v.size(); ++k) {
    const double mass = system.lumped[k / d];
    v[k] = system.held[k] || mass == 0 ? 0 : v[k] / mass;
  }
  return v;
}

}  // namespace tether::fem
