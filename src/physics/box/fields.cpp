// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/fields.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/numbers.hpp"
#include "physics/box/liquid/facets.hpp"
#include "physics/box/projection.hpp"

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

/// What fields of cells are made from.
struct CellSource {
  const StaggeredGrid& grid;
  const FlowDomain& domain;
  const CoupledState& state;
  const liquid::Surface* surface = nullptr;  ///< of a liquid
  const WholeSurface& whole;                 ///< of bodies and obstacles

  /// What the cell holds: sealed air is air, and what obstacles that cut cells have is theirs.
  CellKind kind(std::size_t cell) const {
    const CellKind kind = domain.kind[cell];
    if (kind == CellKind::solid && whole.in_obstacle(cell)) return CellKind::wall;
    return surface != nullptr && kind == CellKind::fluid && surface->distance[cell] >= 0 ? CellKind::empty : kind;
  }
  bool fluid(std::size_t cell) const { return kind(cell) == CellKind::fluid; }
  /// The mean of its two faces.
  double velocity(int axis, std::size_t cell) const {
    auto face = grid.place_of_cell(cell);
    const double low = state.v[at(axis)][grid.face(axis, face)];
    ++face[at(axis)];
    return 0.5 * (low + state.v[at(axis)][grid.face(axis, face)]);
  }
};

struct CellSetting : ColumnSetting {
  bool with_smoke = false, with_liquid = false;
};

const ColumnTable<CellSetting, CellSource>& cell_table() {
  using S = CellSource;
  using Row = Column<CellSetting, S>;
  using D = Dimension;
  const auto velocity = [](const S& s, std::size_t axis, std::size_t c) {
    return s.fluid(c) ? s.velocity(static_cast<int>(axis), c) : 0;
  };
  const When<CellSetting> liquid("with a liquid", [](const CellSetting& s) { return s.with_liquid; });
  const When<CellSetting> smoke("with smoke", [](const CellSetting& s) { return s.with_smoke; });
  static const ColumnTable<CellSetting, S> table({{{
      Row("v", D::velocity, "velocity, zero where there is no fluid", velocity).vector(),
      {"p", D::stress, "pressure, of the last step, before the first one not a number; zero where there is no fluid",
       [](const S& s, std::size_t c) { return !s.fluid(c)           ? 0
                                              : s.state.dt_last > 0 ? s.state.p[c]
                                                                    : no_number; }},
      {"kind", D::whole, "fluid 0, solid 1, obstacle 2, void or air 3",
       [](const S& s, std::size_t c) { return static_cast<double>(s.kind(c)); }},
      {"region", D::whole, "part of the fluid that the cell belongs to, from 1; 0 without fluid",
       [](const S& s, std::size_t c) { return s.domain.region[c] + 1.0; }},
      Row("smoke", D::number, "density of smoke", [](const S& s, std::size_t c) { return s.state.smoke.density(c); })
          .when(smoke),
      Row("temperature", D::number, "above that of the surroundings",
          [](const S& s, std::size_t c) { return s.state.smoke.temperature(c); })
          .when(smoke),
      Row("surface", D::number, "distance from the liquid's surface in cells, below 0 in the liquid",
          [](const S& s, std::size_t c) { return s.surface->distance[c]; })
          .when(liquid),
  }}});
  return table;
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

/// Density times gravity, with what smoke and warmth do, times depth below or height above the level outside, times
/// volume: what rounding makes of a fluid at rest is small against it.
double CoupledFields::pressure_energy(const CoupledState& state) const {
  const FlowDomain& domain = step_.domain();
  const Coupled& coupled = *scene_.coupled();
  double sum = 0;
  for (std::size_t c = 0; c < domain.kind.size(); ++c) {
    if (domain.kind[c] != CellKind::fluid) continue;
    const Vec<3> gravity = gravity_of(scene_);
    double pull = std::sqrt(dot(gravity, gravity));
    if (coupled.smoke)
      pull += std::abs(coupled.smoke_lift * state.smoke.temperature(c)) +
              std::abs(coupled.smoke_weight * state.smoke.density(c));
    sum += pull * std::abs(domain.grid.middle(1, domain.grid.place_of_cell(c)[1]) - coupled.level);
  }
  return coupled.density * domain.grid.volume() * sum;
}

CoupledSums CoupledFields::sums_of(const CoupledState& state) const {
  const SolidEquations& solids = step_.solids();
  const Coupled& coupled = *scene_.coupled();
  const FlowDomain& domain = step_.domain();
  CoupledSums s{{}, state};
  s.time = state.time, s.dt = state.dt_last;
  add_motion_of_solids(state, s);
  coupled.liquid ? add_liquid(state, s) : add_fluid(state, s);
  s.strain = solids.system.elements->strain_energy(state.q) + solids.spring_energy(state.q);
  s.potential += solids.system.gravity_energy(state.q);
  s.contact = state.contact;
  s.total = s.kinetic + s.strain + s.potential + s.contact.last.energy;
  s.mass += sum_of(solids.system.weights);
  s.pressure_energy = pressure_energy(state), s.regions = static_cast<double>(domain.regions);
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

/// What fills the room: mass, momentum and energy are those of the faces.
void CoupledFields::add_fluid(const CoupledState& state, CoupledSums& sums) const {
  const Coupled& coupled = *scene_.coupled();
  const FlowDomain& domain = step_.domain();
  for (std::size_t axis = 0; axis < at(coupled.grid.dim); ++axis) {
    for (std::size_t f = 0; f < state.v[axis].size(); ++f) {
      if (domain.face[axis][f] == FaceKind::open)
        sums.momentum[axis] += coupled.density * domain.volume[axis][f] * state.v[axis][f];
    }
  }
  sums.fluid = kinetic_energy(domain, state.v, state.v, coupled.density), sums.kinetic += sums.fluid;
  sums.fluid_volume = fluid_volume(domain, coupled.coupling.cuts_faces);
  sums.mass += coupled.density * sums.fluid_volume;
}

/// A liquid's are those of its particles.
void CoupledFields::add_liquid(const CoupledState& state, CoupledSums& sums) const {
  const Coupled& coupled = *scene_.coupled();
  liquid::LiquidSums& of = sums.liquid;
  of = liquid::sums_of(state.particles, coupled.grid.dim, coupled.density, gravity_of(scene_));
  liquid::add_surface(*step_.surface_of_liquid(), of);
  const double mass = coupled.density * of.volume;
  for (std::size_t axis = 0; axis < at(coupled.grid.dim); ++axis) sums.momentum[axis] += mass * of.velocity[axis];
  sums.fluid = of.kinetic, sums.kinetic += of.kinetic, sums.potential += of.gravity;
  sums.fluid_volume = of.enclosed, sums.mass += mass;
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

Snapshot CoupledFields::cell_fields(const CoupledState& state) const {
  const Coupled& box = *scene_.coupled();
  const CellSetting setting{{box.grid.dim, {}, {}}, box.smoke, box.liquid.has_value()};
  return Columns<CellSource>(cell_table(), setting)
      .snapshot(state.time, box.grid.cell_count(),
                {box.grid, step_.domain(), state, step_.surface_of_liquid(), step_.whole_surface()});
}

namespace {

const ColumnTable<ColumnSetting, liquid::Particles>& particle_table() {
  using P = liquid::Particles;
  using Row = Column<ColumnSetting, P>;
  using D = Dimension;
  const auto place = [](const P& p, std::size_t axis, std::size_t k) { return p.x[axis][k]; };
  const auto velocity = [](const P& p, std::size_t axis, std::size_t k) { return p.v[axis][k]; };
  static const ColumnTable<ColumnSetting, P> table({{{
      Row("", D::length, "place of a particle of liquid", place).vector(),
      Row("v", D::velocity, "its velocity", velocity).vector(),
      {"volume", D::volume, "volume that it stands for", [](const P& p, std::size_t k) { return p.volume[k]; }},
  }}});
  return table;
}

}  // namespace

Snapshot CoupledFields::particle_fields(const CoupledState& state) const {
  const Coupled& box = *scene_.coupled();
  if (state.particles.size() == 0) return {state.time, {}};
  return Columns<liquid::Particles>(particle_table(), {box.grid.dim, {}, {}})
      .snapshot(state.time, state.particles.size(), state.particles);
}

/// Where there is no surface, one facet stands for it whose places are no numbers.
Snapshot CoupledFields::surface_fields(const CoupledState& state) const {
  if (step_.surface_of_liquid() == nullptr) return {state.time, {}};
  const int dim = scene_.coupled()->grid.dim;
  std::vector<liquid::Facet> facets = liquid::facets_of(*step_.surface_of_liquid());
  if (facets.empty()) facets.push_back(liquid::Facet{Vec<3>{no_number, no_number, no_number}});
  const auto place = [dim](const std::vector<liquid::Facet>& of, std::size_t axis, std::size_t corner) {
    return of[corner / at(dim)][corner % at(dim)][axis];
  };
  const ColumnTable<ColumnSetting, std::vector<liquid::Facet>> table(
      {{{Column<ColumnSetting, std::vector<liquid::Facet>>("", Dimension::length, "place of a corner of the surface",
                                                           place)
             .vector()}}});
  return Columns<std::vector<liquid::Facet>>(table, {dim, {}, {}})
      .snapshot(state.time, facets.size() * at(dim), facets);
}

Snapshot CoupledFields::solid_fields(const CoupledState& state) const {
  if (!scene_.solids()) return {state.time, {}};
  const fem::SolidSystem& system = step_.solids().system;
  return fem::shape_fields(state.time, system.solids.mesh, *system.elements, state.q, state.u,
                           system.solids.contact ? &state.contact.last : nullptr);
}

}  // namespace tether::coupled
