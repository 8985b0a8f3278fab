// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/fields.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/numbers.hpp"

namespace tether::coupled {
namespace {

/// Each part's share of the nodes' masses.
std::vector<std::vector<double>> masses_of_parts(const std::vector<int>& part, int parts,
                                                 const std::vector<double>& weights) {
  std::vector<std::vector<double>> masses(at(parts), std::vector<double>(weights.size(), 0.0));
  for (std::size_t n = 0; n < weights.size(); ++n) {
    if (part[n] >= 0) masses[at(part[n])][n] = weights[n];
  }
  return masses;
}

double sum_of(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

/// `parts` bodies, where there are solids.
CoupledSetting setting_of(const Scene& scene, const CoupledStep& step, std::size_t parts) {
  const Coupled& box = *scene.coupled();
  CoupledSetting setting{{{box.grid.dim, {}, {}}},
                         scene.solids() != nullptr,
                         box.smoke,
                         box.liquid.has_value(),
                         enclosed_volumes(step.surface(), step.solids().system.solids.mesh.x)};
  if (!scene.solids()) return setting;
  std::vector<std::string> names;
  for (std::size_t b = 0; b < parts; ++b) names.push_back(fmt::format("body {}", b + 1));
  static_cast<fem::MeshSetting&>(setting) = fem::mesh_setting(*scene.solids(), names);
  return setting;
}

}  // namespace

CoupledFields::CoupledFields(const Scene& scene, const CoupledStep& step)
    : scene_(scene),
      step_(step),
      part_of_node_(parts_of(step.solids().system.solids.mesh)),
      part_masses_(masses_of_parts(part_of_node_, step.surface().parts, step.solids().system.weights)),
      columns_(coupled_table(), setting_of(scene, step, part_masses_.size())) {
  const SolidSurface& surface = step.surface();
  for (std::size_t s = 0; s < surface.side_count(); ++s) {
    part_of_sheet_.resize(std::max(part_of_sheet_.size(), at(surface.sheet[s]) + 1));
    part_of_sheet_[at(surface.sheet[s])] = at(surface.part[s]);
  }
}

CoupledSums CoupledFields::sums_of(const CoupledState& state) const {
  const SolidEquations& solids = step_.solids();
  CoupledSums s{{}, state};
  s.time = state.time, s.dt = state.dt_last;
  add_motion_of_solids(state, s);
  step_.flow().add_sums(state, s);
  s.strain = solids.system.elements->strain_energy(state.q) + solids.spring_energy(state.q);
  s.potential += solids.system.gravity_energy(state.q);
  s.contact = state.contact;
  s.total = s.kinetic + s.strain + s.potential + s.contact.last.energy;
  s.mass += sum_of(solids.system.weights);
  s.pressure_energy = step_.flow().pressure_energy(state), s.regions = step_.flow().regions().count;
  s.smoke_mass = sum_of(state.smoke.smoke);
  for (std::size_t cell = 0; cell < state.smoke.smoke.size(); ++cell)
    s.smoke_largest = std::max(s.smoke_largest, state.smoke.density(cell));
  if (scene_.solids()) add_bodies(state, s);
  return s;
}

void CoupledFields::add_motion_of_solids(const CoupledState& state, CoupledSums& sums) const {
  std::vector<double> momenta(state.u.size());
  step_.solids().system.multiply_mass(state.u, momenta);
  for (std::size_t k = 0; k < momenta.size(); ++k) {
    sums.kinetic += 0.5 * momenta[k] * state.u[k];
    sums.momentum[k % at(scene_.coupled()->grid.dim)] += momenta[k];
  }
}

/// Sums the forces on the nodes of each part.
std::vector<Components> CoupledFields::forces_of_parts(std::span<const double> forces) const {
  const std::size_t d = at(scene_.coupled()->grid.dim);
  std::vector<Components> sums(part_masses_.size());
  for (std::size_t n = 0; n < part_of_node_.size(); ++n) {
    for (std::size_t i = 0; i < d && part_of_node_[n] >= 0; ++i) sums[at(part_of_node_[n])][i] += forces[n * d + i];
  }
  return sums;
}

void CoupledFields::add_bodies(const CoupledState& state, CoupledSums& sums) const {
  sums.least = step_.solids().system.elements->shape(state.q).least;
  sums.sheets = enclosed_volumes(step_.surface(), state.q);
  sums.volumes.assign(part_masses_.size(), 0.0);
  for (std::size_t s = 0; s < sums.sheets.size(); ++s) sums.volumes[part_of_sheet_[s]] += sums.sheets[s];
  sums.nodes_inside = static_cast<double>(state.overlap.now);
  sums.force = forces_of_parts(state.fluid_force), sums.hold = forces_of_parts(state.wall_force);
  for (const auto& masses : part_masses_)
    sums.bodies.push_back(fem::body_of(sum_of(masses), masses, state.q, state.u, at(scene_.coupled()->grid.dim)));
  sums.tracked = fem::tracked_of(*scene_.solids(), state.q, state.u);
}

Snapshot CoupledFields::solid_fields(const CoupledState& state) const {
  if (!scene_.solids()) return {state.time, {}};
  const fem::SolidSystem& system = step_.solids().system;
  return fem::shape_fields(state.time, system.solids.mesh, *system.elements, state.q, state.u,
                           system.solids.contact ? &state.contact.last : nullptr);
}

}  // namespace tether::coupled
