// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "physics/box/columns.hpp"
#include "physics/box/grid_flow.hpp"
#include "results/summary_keys.hpp"

namespace tether::coupled {

// What a flow on the grid shows of itself.

namespace {

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

/// Mass, momentum and energy are those of the faces.
void GridFlow::add_sums(const CoupledState& state, CoupledSums& sums) const {
  for (std::size_t axis = 0; axis < at(scene_.grid.dim); ++axis) {
    for (std::size_t f = 0; f < state.v[axis].size(); ++f) {
      if (at_.domain.face[axis][f] == FaceKind::open)
        sums.momentum[axis] += scene_.density * at_.domain.volume[axis][f] * state.v[axis][f];
    }
  }
  sums.fluid = energy_of(state.v), sums.kinetic += sums.fluid;
  sums.fluid_volume = fluid_volume(at_.domain, scene_.coupling.cuts_faces);
  sums.mass += scene_.density * sums.fluid_volume;
}

/// Density times gravity, with what smoke and warmth do, times depth below or height above the level outside, times
/// volume: what rounding makes of a fluid at rest is small against it.
double GridFlow::pressure_energy(const CoupledState& state) const {
  double sum = 0;
  for (std::size_t c = 0; c < at_.domain.kind.size(); ++c) {
    if (at_.domain.kind[c] != CellKind::fluid) continue;
    double pull = std::sqrt(dot(gravity_, gravity_));
    if (scene_.smoke)
      pull += std::abs(scene_.smoke_lift * state.smoke.temperature(c)) +
              std::abs(scene_.smoke_weight * state.smoke.density(c));
    sum += pull * std::abs(at_.domain.grid.middle(1, at_.domain.grid.place_of_cell(c)[1]) - scene_.level);
  }
  return scene_.density * at_.domain.grid.volume() * sum;
}

Snapshot GridFlow::cell_fields(const CoupledState& state) const {
  const CellSetting setting{{scene_.grid.dim, {}, {}}, scene_.smoke, scene_.liquid.has_value()};
  return Columns<CellSource>(cell_table(), setting)
      .snapshot(state.time, scene_.grid.cell_count(),
                {scene_.grid, at_.domain, state, at_.surface ? &*at_.surface : nullptr, placer_.whole()});
}

std::size_t GridFlow::fluid_cells() const {
  const auto& kind = at_.domain.kind;
  return static_cast<std::size_t>(std::count(kind.begin(), kind.end(), CellKind::fluid));
}

void GridFlow::add_summary(Summary& summary) const {
  const auto volume_of = [&](CellKind kind) {
    const auto& kinds = at_.domain.kind;
    return static_cast<double>(std::count(kinds.begin(), kinds.end(), kind)) * scene_.grid.volume();
  };
  if (!scene_.obstacles.empty()) summary.push_back(line_of("obstacle_volume", volume_of(CellKind::wall)));
  if (!scene_.voids.empty() && !scene_.cavities_only)
    summary.push_back(line_of("void_volume", volume_of(CellKind::empty)));
}

}  // namespace tether::coupled
