// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/coupled/coupled_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "base/index.hpp"
#include "solvers/coupled/projection.hpp"
#include "solvers/fem/mesh_fields.hpp"
#include "solvers/fem/solid_fields.hpp"

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

/// Cells that are wholly fluid or not are counted; where they are cut, the faces have it, all of it along each axis:
/// those to obstacles and void half as much as those between fluid.
double fluid_volume(const FlowDomain& domain, bool cut) {
  const auto holds = [&](int cell) { return domain.kind[at(cell)] == CellKind::fluid; };
  double volume = 0;
  if (!cut)
    return domain.grid.volume() *
           static_cast<double>(std::count(domain.kind.begin(), domain.kind.end(), CellKind::fluid));
  for (int axis = 0; axis < domain.grid.dim; ++axis) {
    for (std::size_t f = 0; f < domain.volume[at(axis)].size(); ++f) {
      const auto [low, high] = cells_beside(domain.grid, axis, f);
      const bool whole = low < 0 || high < 0 || (holds(low) && holds(high));
      volume += (whole ? 1 : 0.5) * domain.volume[at(axis)][f] / domain.grid.dim;
    }
  }
  return volume;
}

double sum_of(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

}  // namespace

CoupledFields::CoupledFields(const Scene& scene, const CoupledStep& step)
    : scene_(scene), step_(step), first_volumes_(enclosed_volumes(step.surface(), step.solids().system.solids.mesh.x)) {
  const fem::SolidSystem& system = step.solids().system;
  part_of_sheet_.resize(first_volumes_.size());
  for (std::size_t s = 0; s < step.surface().side_count(); ++s)
    part_of_sheet_[at(step.surface().sheet[s])] = at(step.surface().part[s]);
  part_masses_ = masses_of_parts(parts_of(system.solids.mesh), step.surface().parts, system.weights);
}

/// The columns of the books, in the order of booked().
void CoupledFields::add_books(HistoryLayout& layout) const {
  const auto add = [&](const char* name, Book book, const char* meaning) {
    layout.quantities.push_back({name, Dimension::energy, meaning, Per::scene, book});
  };
  using enum Book;
  add("energy_jets", gained, "work of the pressure at jets, and kinetic energy that they carried in");
  add("energy_open", gained, "the same of open sides, by the pressure outside, and of voids");
  add("energy_gravity", gained, "work of gravity on the fluid");
  add("energy_buoyancy", gained, "work of smoke and warmth on the fluid");
  add("energy_outside", gained, "work of loads and moved supports on the solids");
  add("energy_viscous", given, "what viscosity took");
  add("energy_damped", given, "what damping of the solids took");
  add("energy_contact", given, "what walls, obstacles and friction took of the solids");
  add("energy_advected", lost, "kinetic energy lost as the fluid carries its velocity along");
  add("energy_remeshed", lost, "kinetic energy lost as solids open and close faces");
  add("energy_projected", lost, "kinetic energy that pressures and forces took by acting at a step's end");
  add("energy_sources", lost, "what the volume term took, less what it gave");
  add("energy_coupling", lost, "what the fluid gave the solids less what they took");
  add("energy_solid_step", lost, "work of the solids' own forces less what is stored of it");
}

Record CoupledFields::booked(const EnergyBooks& books) {
  return {books.jets,      books.open_sides, books.gravity,  books.buoyancy,  books.loads,
          books.viscous,   books.damped,     books.contact,  books.advected,  books.remeshed,
          books.projected, books.sources,    books.coupling, books.solid_step};
}

/// Density times gravity, with what smoke and warmth do, times depth below or height above the level outside, times
/// volume: what rounding makes of a fluid at rest is small against it.
double CoupledFields::pressure_energy(const CoupledState& state) const {
  const FlowDomain& domain = step_.domain();
  const Coupled& coupled = *scene_.coupled();
  double sum = 0;
  for (std::size_t c = 0; c < domain.kind.size(); ++c) {
    if (domain.kind[c] != CellKind::fluid) continue;
    double pull = std::abs(scene_.gravity);
    if (coupled.smoke)
      pull += std::abs(coupled.smoke_lift * state.smoke.temperature(c)) +
              std::abs(coupled.smoke_weight * state.smoke.density(c));
    sum += pull * std::abs(domain.grid.middle(1, domain.grid.place_of_cell(c)[1]) - coupled.level);
  }
  return coupled.density * domain.grid.volume() * sum;
}

HistoryLayout CoupledFields::history_layout() const {
  HistoryLayout layout;
  const int dim = scene_.coupled()->grid.dim;
  const auto add = [&](const std::string& name, Dimension dimension, const std::string& meaning) {
    layout.quantities.push_back({name, dimension, meaning});
  };
  fem::add_energies(layout);
  add("energy_fluid", Dimension::energy, "kinetic energy of the fluid, part of energy_kinetic");
  add("mass", Dimension::mass, "mass of fluid and solids");
  fem::add_vector(layout, "momentum_", Dimension::momentum, "momentum of fluid and solids in ", dim);
  add("fluid_volume", Dimension::volume, "volume of the fluid, by its cells");
  add("interface_power", Dimension::power, "power that the solids took from the fluid in the last step");
  add("interface_work", Dimension::energy, "energy that they have taken");
  add("interface_mismatch", Dimension::number,
      "power that the fluid gave less that which the solids took in the last step, over the sum of its parts' sizes, "
      "at "
      "least a thousandth of the powers in the fluid");
  add_books(layout);
  add("energy_pressure", Dimension::energy,
      "pressure of a fluid at rest, by its depth, times its volume: rounding at rest is small against it");
  add("cfl", Dimension::number, "cells that the fluid crossed along an axis where it was fastest, in the last step");
  add("regions", Dimension::number, "parts of the fluid that nothing joins");
  add("solver_iterations", Dimension::number, "iterations of linear solvers since the start");
  if (scene_.coupled()->smoke) {
    add("smoke_mass", Dimension::volume, "density of smoke times volume");
    add("smoke_in", Dimension::volume, "smoke that jets have brought, and fluid from outside");
    add("smoke_out", Dimension::volume, "smoke that has left");
    add("smoke_largest", Dimension::number, "largest density of smoke");
  }
  if (!scene_.solids()) return layout;
  fem::add_shape(layout);
  fem::add_overlap(layout);
  for (std::size_t s = 0; s < first_volumes_.size(); ++s) {
    add(fmt::format("volume_sheet_{}", s + 1), Dimension::volume,
        first_volumes_[s] < 0 ? "volume of a cavity in the solids"
                              : "volume that an outer surface of the solids encloses");
  }
  fem::add_vector(layout, "body_force_", Dimension::force, "force of the fluid in the last step, ", dim, Per::body);
  fem::add_vector(layout, "body_hold_", Dimension::force, "force of supports and walls in the last step, ", dim,
                  Per::body);
  std::vector<std::string> names;
  for (std::size_t b = 0; b < part_masses_.size(); ++b) names.push_back(fmt::format("body {}", b + 1));
  fem::add_bodies_and_nodes(layout, *scene_.solids(), names);
  return layout;
}

Record CoupledFields::record(const CoupledState& state) const {
  const SolidEquations& solids = step_.solids();
  const Coupled& coupled = *scene_.coupled();
  const FlowDomain& domain = step_.domain();
  std::vector<double> momenta(state.u.size());
  solids.system.multiply_mass(state.u, momenta);
  const double volume = fluid_volume(domain, coupled.mode == CouplingMode::cut_cell);
  double kinetic = 0;
  for (std::size_t k = 0; k < momenta.size(); ++k) kinetic += 0.5 * momenta[k] * state.u[k];
  Vector momentum{};
  for (std::size_t k = 0; k < momenta.size(); ++k) momentum[k % at(coupled.grid.dim)] += momenta[k];
  for (std::size_t axis = 0; axis < at(coupled.grid.dim); ++axis) {
    for (std::size_t f = 0; f < state.v[axis].size(); ++f) {
      if (domain.face[axis][f] == FaceKind::open)
        momentum[axis] += coupled.density * domain.volume[axis][f] * state.v[axis][f];
    }
  }
  const double fluid = kinetic_energy(domain, state.v, state.v, coupled.density);
  const double strain = solids.system.elements->strain_energy(state.q) + solids.spring_energy(state.q);
  const double potential = solids.system.gravity_energy(state.q);
  Record values{state.time,
                state.dt_last,
                kinetic + fluid,
                strain,
                0,
                potential,
                kinetic + fluid + strain + potential,
                fluid,
                coupled.density * volume + sum_of(solids.system.weights)};
  values.insert(values.end(), momentum.begin(), momentum.begin() + coupled.grid.dim);
  values.insert(values.end(), {volume, state.last.interface_power, state.work, state.last.mismatch});
  const Record books = booked(state.books);
  values.insert(values.end(), books.begin(), books.end());
  values.insert(values.end(), {pressure_energy(state), state.last.cfl, static_cast<double>(domain.regions),
                               static_cast<double>(state.iterations)});
  if (coupled.smoke) add_smoke(state, values);
  if (scene_.solids()) add_bodies(state, values);
  return values;
}

void CoupledFields::add_smoke(const CoupledState& state, Record& record) const {
  double largest = 0;
  for (std::size_t cell = 0; cell < state.smoke.smoke.size(); ++cell)
    largest = std::max(largest, state.smoke.density(cell));
  record.insert(record.end(),
                {sum_of(state.smoke.smoke), state.smoke_flow.smoke_in, state.smoke_flow.smoke_out, largest});
}

void CoupledFields::add_forces(std::span<const double> forces, Record& record) const {
  const std::size_t d = at(scene_.coupled()->grid.dim);
  for (std::size_t i = 0; i < d; ++i) {
    for (const auto& masses : part_masses_) {
      double sum = 0;
      for (std::size_t n = 0; n < masses.size(); ++n) sum += masses[n] > 0 ? forces[n * d + i] : 0;
      record.push_back(sum);
    }
  }
}

/// As history_layout() and add_bodies_and_nodes() list them.
void CoupledFields::add_bodies(const CoupledState& state, Record& record) const {
  const std::size_t d = at(scene_.coupled()->grid.dim);
  record.push_back(step_.solids().system.elements->shape(state.q).least);
  const std::vector<double> enclosed = enclosed_volumes(step_.surface(), state.q);
  std::vector<double> volumes(part_masses_.size(), 0.0);
  for (std::size_t s = 0; s < enclosed.size(); ++s) volumes[part_of_sheet_[s]] += enclosed[s];
  record.insert(record.end(), volumes.begin(), volumes.end());
  record.push_back(static_cast<double>(state.overlap.now));
  for (const double volume : enclosed) record.push_back(std::abs(volume));
  add_forces(state.fluid_force, record);
  add_forces(state.wall_force, record);
  for (const auto* values : {&state.q, &state.u}) {
    for (std::size_t i = 0; i < d; ++i) {
      for (const auto& masses : part_masses_) {
        double sum = 0;
        for (std::size_t n = 0; n < masses.size(); ++n) sum += masses[n] * (*values)[n * d + i];
        record.push_back(sum / sum_of(masses));
      }
    }
  }
  for (const auto& masses : part_masses_) record.push_back(sum_of(masses));
  fem::append_tracked(*scene_.solids(), state.q, state.u, record);
}

/// Velocities are the means of a cell's two faces.
Snapshot CoupledFields::cell_fields(const CoupledState& state) const {
  constexpr std::array axes{"x", "y", "z"};
  const StaggeredGrid& grid = scene_.coupled()->grid;
  const FlowDomain& domain = step_.domain();
  Snapshot snapshot{state.time, {}};
  const auto add = [&](const std::string& name, Dimension dimension, const char* meaning, const auto& value) {
    Field field{{name, dimension, meaning}, std::vector<double>(grid.cell_count())};
    for (std::size_t c = 0; c < field.values.size(); ++c) field.values[c] = value(c);
    snapshot.fields.push_back(std::move(field));
  };
  for (int axis = 0; axis < grid.dim; ++axis) {
    add(axes[at(axis)], Dimension::length, "place",
        [&](std::size_t c) { return grid.middle(axis, grid.place_of_cell(c)[at(axis)]); });
  }
  for (int axis = 0; axis < grid.dim; ++axis) {
    add(std::string("v") + axes[at(axis)], Dimension::velocity, "velocity, zero where there is no fluid",
        [&](std::size_t c) {
          auto face = grid.place_of_cell(c);
          const double low = state.v[at(axis)][grid.face(axis, face)];
          ++face[at(axis)];
          return domain.kind[c] == CellKind::fluid ? 0.5 * (low + state.v[at(axis)][grid.face(axis, face)]) : 0;
        });
  }
  add("p", Dimension::stress, "pressure, of the last step",
      [&](std::size_t c) { return domain.kind[c] == CellKind::fluid ? state.p[c] : 0; });
  add("kind", Dimension::number, "fluid 0, solid 1, obstacle 2, void 3",
      [&](std::size_t c) { return static_cast<double>(domain.kind[c]); });
  add("region", Dimension::number, "part of the fluid that the cell belongs to, from 1; 0 without fluid",
      [&](std::size_t c) { return domain.region[c] + 1.0; });
  if (scene_.coupled()->smoke) {
    add("smoke", Dimension::number, "density of smoke", [&](std::size_t c) { return state.smoke.density(c); });
    add("temperature", Dimension::number, "above that of the surroundings",
        [&](std::size_t c) { return state.smoke.temperature(c); });
  }
  return snapshot;
}

Snapshot CoupledFields::solid_fields(const CoupledState& state) const {
  if (!scene_.solids()) return {state.time, {}};
  return fem::shape_fields(state.time, step_.solids().system, state.q, state.u);
}

}  // namespace tether::coupled
