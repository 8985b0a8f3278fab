// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "base/numbers.hpp"
#include "physics/box/columns.hpp"
#include "physics/box/mesh/mesh_flow.hpp"
#include "results/summary_keys.hpp"

namespace tether::coupled {

// What a flow on a mesh shows of itself.

namespace {

/// What the middles of the grid's cells show of the mesh.
struct RasterSource {
  std::vector<Vec<3>> v;
  std::vector<double> p;
  std::vector<int> region;  ///< -1: no fluid
  std::vector<CellKind> kind;
  std::vector<double> smoke, warmth;  ///< where there is smoke
};

struct RasterSetting : ColumnSetting {
  bool with_smoke = false;
};

template <class Source>
Column<RasterSetting, Source> smoke_row(const char* name, const char* meaning, std::vector<double> Source::*values) {
  return Column<RasterSetting, Source>(name, Dimension::number, meaning,
                                       [values](const Source& s, std::size_t c) { return (s.*values)[c]; })
      .when(When<RasterSetting>("with smoke", [](const RasterSetting& s) { return s.with_smoke; }));
}

const ColumnTable<RasterSetting, RasterSource>& raster_table() {
  using S = RasterSource;
  using Row = Column<RasterSetting, S>;
  using D = Dimension;
  static const ColumnTable<RasterSetting, S> table({{{
      Row("v", D::velocity, "velocity, zero where there is no fluid",
          [](const S& s, std::size_t axis, std::size_t c) { return s.v[c][axis]; })
          .vector(),
      {"p", D::stress, "pressure, of the last step, before the first one not a number; zero where there is no fluid",
       [](const S& s, std::size_t c) { return s.p[c]; }},
      {"kind", D::whole, "fluid 0, solid 1, obstacle 2, void, with what is in it, 3",
       [](const S& s, std::size_t c) { return static_cast<double>(s.kind[c]); }},
      {"region", D::whole, "part of the fluid that the cell belongs to, from 1; 0 without fluid",
       [](const S& s, std::size_t c) { return s.region[c] + 1.0; }},
      smoke_row<S>("smoke", "density of smoke", &S::smoke),
      smoke_row<S>("temperature", "above that of the surroundings", &S::warmth),
  }}});
  return table;
}

/// What the corners of cells show of the mesh.
struct CornerSource {
  const FlowMesh& mesh;
  const CoupledState& state;
  std::vector<double> p;
  std::vector<double> smoke, warmth;  ///< where there is smoke

  std::size_t cell(std::size_t corner) const { return corner / mesh.corners(); }
  const Vec<3>& place(std::size_t corner) const { return mesh.x[at(mesh.nodes[corner])]; }
};

const ColumnTable<RasterSetting, CornerSource>& corner_table() {
  using S = CornerSource;
  using Row = Column<RasterSetting, S>;
  using D = Dimension;
  static const ColumnTable<RasterSetting, S> table({{{
      Row("", D::length, "place of a corner of a cell",
          [](const S& s, std::size_t axis, std::size_t c) { return s.place(c)[axis]; })
          .vector(),
      Row("v", D::velocity, "velocity of the cell",
          [](const S& s, std::size_t axis, std::size_t c) { return s.state.v[axis][s.cell(c)]; })
          .vector(),
      {"p", D::stress, "pressure, of the last step, before the first one not a number",
       [](const S& s, std::size_t c) { return s.p[c]; }},
      {"region", D::whole, "part of the fluid that the cell belongs to, from 1",
       [](const S& s, std::size_t c) { return s.mesh.region[s.cell(c)] + 1.0; }},
      smoke_row<S>("smoke", "density of smoke", &S::smoke),
      smoke_row<S>("temperature", "above that of the surroundings", &S::warmth),
  }}});
  return table;
}

/// Where a cell of the grid is asked; in the plane at z = 0.
Vec<3> middle_of(const StaggeredGrid& grid, std::size_t c) {
  const Vec<3> x = grid.middle(grid.place_of_cell(c));
  return {x[0], x[1], grid.dim == 2 ? 0 : x[2]};
}

/// What is at a place that no cell has.
CellKind kind_without_fluid(const Coupled& scene, const Vec<3>& x) {
  if (in_obstacle(scene, x)) return CellKind::wall;
  return scene.cavities_only ? CellKind::empty : CellKind::solid;
}

}  // namespace

void MeshFlow::add_sums(const CoupledState& state, CoupledSums& sums) const {
  const auto of_velocity = mesh_of(state.flow_q);
  const FlowMesh& mesh = *of_velocity;
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
    sums.fluid_volume += mesh.volume[cell];
    for (std::size_t a = 0; a < at(mesh.dim); ++a)
      sums.momentum[a] += scene_.density * mesh.volume[cell] * state.v[a][cell];
  }
  sums.fluid = kinetic_energy_on(mesh, state.v, state.v), sums.kinetic += sums.fluid;
  sums.mass += scene_.density * sums.fluid_volume;
}

double MeshFlow::pressure_energy(const CoupledState& state) const {
  const FlowMesh& mesh = *at_.mesh;
  double sum = 0;
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
    double pull = std::sqrt(dot(gravity_, gravity_));
    if (scene_.smoke) pull += std::abs(buoyancy(state.smoke, cell));
    sum += pull * mesh.volume[cell] * std::abs(mesh.middle(cell)[1] - scene_.level);
  }
  return scene_.density * sum;
}

void MeshFlow::add_summary(Summary& summary) const {
  summary.push_back(line_of("mesh_cells", at_.mesh->cells()));
  summary.push_back(line_of("mesh_pressures", at_.pressures.face_of.size()));
}

namespace {

/// Smoke at the middles of the grid's cells, on the mesh that it is on.
void add_smoke(const StaggeredGrid& grid, const FlowMesh& mesh, const Smoke& smoke, RasterSource& source) {
  std::vector<double> density, temperature;
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell)
    density.push_back(smoke.density(cell)), temperature.push_back(smoke.temperature(cell));
  const CellField smoke_field(mesh, density), warmth_field(mesh, temperature);
  const CellFinder finder(mesh);
  for (std::size_t c = 0; c < grid.cell_count(); ++c) {
    Vec<3> x = middle_of(grid, c);
    const std::size_t cell = finder.cell_at(x);
    const bool fluid = x == middle_of(grid, c);
    source.smoke.push_back(fluid ? smoke_field.limited_at(cell, x) : 0);
    source.warmth.push_back(fluid ? warmth_field.limited_at(cell, x) : 0);
  }
}

}  // namespace

Snapshot MeshFlow::cell_fields(const CoupledState& state) const {
  const StaggeredGrid& grid = scene_.grid;
  const auto of_velocity = mesh_of(state.flow_q);
  const FlowMesh& mesh = *of_velocity;
  const MeshVelocity velocity(mesh, state.v);
  RasterSource source;
  for (std::size_t c = 0; c < grid.cell_count(); ++c) {
    Vec<3> x = middle_of(grid, c);
    const std::size_t cell = velocity.finder().cell_at(x);
    const bool fluid = x == middle_of(grid, c);
    source.v.push_back(fluid ? velocity.velocity(cell, x) : Vec<3>{});
    source.p.push_back(!fluid ? 0 : state.dt_last > 0 ? pressure_in(mesh, state.p, cell, x) : no_number);
    source.region.push_back(fluid ? mesh.region[cell] : -1);
    source.kind.push_back(fluid ? CellKind::fluid : kind_without_fluid(scene_, middle_of(grid, c)));
  }
  if (scene_.smoke) add_smoke(grid, *at_.mesh, state.smoke, source);
  return Columns<RasterSource>(raster_table(), {{grid.dim, {}, {}}, scene_.smoke})
      .snapshot(state.time, grid.cell_count(), source);
}

/// On the mesh that the velocity is on.
Snapshot MeshFlow::mesh_fields(const CoupledState& state) const {
  const auto of_velocity = mesh_of(state.flow_q);
  const FlowMesh& mesh = *of_velocity;
  CornerSource source{mesh, state, {}, {}, {}};
  const CellFinder finder(*at_.mesh);
  for (std::size_t c = 0; c < mesh.nodes.size(); ++c) {
    const std::size_t cell = source.cell(c);
    source.p.push_back(state.dt_last > 0 ? pressure_in(mesh, state.p, cell, source.place(c)) : no_number);
    if (!scene_.smoke) continue;
    Vec<3> x = mesh.middle(cell);
    const std::size_t of_smoke = finder.cell_at(x);
    source.smoke.push_back(state.smoke.density(of_smoke)), source.warmth.push_back(state.smoke.temperature(of_smoke));
  }
  return Columns<CornerSource>(corner_table(), {{mesh.dim, {}, {}}, scene_.smoke})
      .snapshot(state.time, mesh.nodes.size(), source);
}

}  // namespace tether::coupled
