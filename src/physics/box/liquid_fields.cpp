// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/numbers.hpp"
#include "physics/box/columns.hpp"
#include "physics/box/liquid/facets.hpp"
#include "physics/box/liquid_flow.hpp"

namespace tether::coupled {

// What a liquid shows of itself.

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

/// A liquid's are those of its particles.
void LiquidFlow::add_sums(const CoupledState& state, CoupledSums& sums) const {
  liquid::LiquidSums& of = sums.liquid;
  of = liquid::sums_of(state.particles, scene_.grid.dim, scene_.density, gravity_);
  liquid::add_surface(*at_.surface, of);
  const double mass = scene_.density * of.volume;
  for (std::size_t axis = 0; axis < at(scene_.grid.dim); ++axis) sums.momentum[axis] += mass * of.velocity[axis];
  sums.fluid = of.kinetic, sums.kinetic += of.kinetic, sums.potential += of.gravity;
  sums.fluid_volume = of.enclosed, sums.mass += mass;
}

Snapshot LiquidFlow::particle_fields(const CoupledState& state) const {
  if (state.particles.size() == 0) return {state.time, {}};
  return Columns<liquid::Particles>(particle_table(), {scene_.grid.dim, {}, {}})
      .snapshot(state.time, state.particles.size(), state.particles);
}

/// Where there is no surface, one facet stands for it whose places are no numbers.
Snapshot LiquidFlow::surface_fields(const CoupledState& state) const {
  const int dim = scene_.grid.dim;
  std::vector<liquid::Facet> facets = liquid::facets_of(*at_.surface);
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

}  // namespace tether::coupled
