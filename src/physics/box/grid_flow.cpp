// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/grid_flow.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "physics/box/bodies.hpp"
#include "physics/box/carry_velocity.hpp"
#include "physics/box/cut_faces.hpp"
#include "physics/box/projection.hpp"
#include "physics/box/smoke_follow.hpp"

namespace tether::coupled {
namespace {

constexpr int layers_around_fluid = 4;

}  // namespace

GridFlow::GridFlow(const Coupled& scene, const Vec<3>& gravity, const SolidSurface& surface,
                   const SolidEquations& solids, Team& team)
    : team_(team),
      scene_(scene),
      gravity_(gravity),
      surface_(surface),
      solids_(solids),
      box_(scene),
      outside_(scene, gravity),
      placer_(scene, surface, solids.system.solids.mesh.x.size(), box_, outside_, team) {}

void GridFlow::take(Placement placement) {
  at_ = std::move(placement);
  regions_ = regions_of(at_.domain, at_.numbers);
}

Flow::Equations GridFlow::equations_at(std::span<const double> q, double by) const {
  Placement at = placed(q);
  return {coupled::pressure_matrix(at.domain, at.numbers, by), std::move(at.map.B), regions_of(at.domain, at.numbers)};
}

void GridFlow::start(CoupledState& state) {
  for (std::size_t axis = 0; axis < at(scene_.grid.dim); ++axis)
    state.v[axis].assign(scene_.grid.face_count(static_cast<int>(axis)), scene_.start[axis]);
  if (scene_.viscosity > 0) state.driven = state.ended = face_values(scene_.grid);
  state.p.assign(scene_.grid.cell_count(), 0.0);
  fill(state);
  if (scene_.smoke) state.smoke = smoke_at_start();
}

void GridFlow::finish_start(double h, CoupledState& state) {
  constexpr double cells_crossed = 1;
  extend(h, cells_crossed, state.v);
  note_thin_bodies(0, state);
}

void GridFlow::begin(CoupledState& state, double h) {
  prescribe(state.time, h, state.v);
  extend_velocity(at_.domain, state.v, layers_around_fluid);
  carry_along(state, h);
}

void GridFlow::carry_along(CoupledState& state, double h) {
  FaceValues carried = state.v;
  carry_velocity(team_, at_.domain, state.v, h, scene_.advection, carried);
  const CarriedIn in = carried_in(scene_, at_.domain, state.v, h);
  state.books.jets += in.jets, state.books.open_sides += in.open_sides;
  state.books.advected += energy_of(state.v) + in.jets + in.open_sides - energy_of(carried);
  state.v = std::move(carried);
}

/// Gravity, smoke and the pressure outside come last: at rest they are to the last digit what pressures balance, and
/// viscosity, which walls feel, would leave no such sum.
void GridFlow::add_forces(const Smoke& smoke, double h, FaceValues& v) const {
  for (std::size_t axis = 0; axis < at(scene_.grid.dim); ++axis) {
    for (std::size_t f = 0; f < v[axis].size() && gravity_[axis] != 0; ++f) {
      if (at_.room().face[axis][f] == FaceKind::open) v[axis][f] += h * gravity_[axis];
    }
  }
  if (scene_.smoke) add_buoyancy(at_.domain, smoke, scene_.smoke_lift, scene_.smoke_weight, h, v);
  outside_.press(at_.domain, h, v);
}

void GridFlow::book_forces(CoupledState& state, double h) const {
  double falling = 0;  // volume times velocity times gravity
  for (std::size_t axis = 0; axis < at(scene_.grid.dim); ++axis) {
    double along = 0;
    for (std::size_t f = 0; f < state.v[axis].size() && gravity_[axis] != 0; ++f) {
      if (at_.domain.face[axis][f] == FaceKind::open) along += at_.domain.volume[axis][f] * state.v[axis][f];
    }
    falling += gravity_[axis] * along;
  }
  state.books.gravity += h * scene_.density * falling;
  if (scene_.smoke)
    state.books.buoyancy +=
        h * buoyancy_power(at_.domain, state.smoke, scene_.smoke_lift, scene_.smoke_weight, scene_.density, state.v);
  state.books.open_sides += h * outside_.power(at_.domain, state.v);
}

void GridFlow::end(const FaceValues& change, CoupledState& state, double h) {
  carry_smoke_along(state, h);
  const double found = energy_of(state.v);
  end_velocities(change, h, state);
  place_moved(state.time + h, state);
  state.books.remeshed += found - energy_of(state.v);
}

/// Leaves what the next step is to find, in cut faces and in the solids.
void GridFlow::extend(double h, double /*cells_crossed*/, FaceValues& v) const {
  if (scene_.coupling.cuts_faces) blend_cut_faces(at_.domain, h, v);
  extend_velocity(at_.domain, v, layers_around_fluid);
}

/// Keeps what the end of this step makes of the velocities that it was given, for friction in the next one.
void GridFlow::end_velocities(const FaceValues& change, double h, CoupledState& state) const {
  const FaceValues given = scene_.viscosity > 0 ? state.v : FaceValues{};
  extend(h, state.last.cfl, state.v);
  if (scene_.viscosity == 0) return;
  for (std::size_t axis = 0; axis < state.v.size(); ++axis) {
    for (std::size_t f = 0; f < state.v[axis].size(); ++f) {
      const bool open = at_.domain.face[axis][f] == FaceKind::open;
      state.ended[axis][f] = open ? (state.v[axis][f] - given[axis][f]) / h : 0;
    }
  }
  take_drive(change, h, state);
  keep_rubbed_faces(given, change, h, state);
}

/// The fluid's cells change with the solids, and smoke goes where there is fluid.
void GridFlow::place_moved(double time, CoupledState& state) {
  const FlowDomain before = std::move(at_.domain);
  at_ = {};  // it takes as much room as the new one
  place_after_step(state);
  if (scene_.smoke) follow_domain(before, at_.domain, state.smoke);
  note_thin_bodies(time, state);
}

/// A warning once, where the cells are first too wide for the bodies.
void GridFlow::note_thin_bodies(double time, CoupledState& state) {
  if (!scene_.coupling.cuts_faces) return;
  const ThinBodies thin = thin_bodies(at_, surface_);
  if (thin.cells > 0 && state.thin_cells == 0)
    messages_.push_back(fmt::format("t = {:.6g}: {}", time, thin_text(thin, surface_.dim)));
  state.thin_cells = std::max(state.thin_cells, static_cast<long long>(thin.cells));
}

// Pressures.

Vec<3> GridFlow::place_of_pressure(std::size_t k) const {
  return scene_.grid.middle(scene_.grid.place_of_cell(at_.numbers.cell[k]));
}

void GridFlow::keep_pressures(std::span<const double> p, CoupledState& state) const {
  state.p.assign(at_.numbers.of_cell.size(), 0.0);
  for (std::size_t k = 0; k < p.size(); ++k) state.p[at_.numbers.cell[k]] = p[k];
  extend_pressure(at_.domain, state.p, layers_around_fluid);
}

SparseMatrix GridFlow::pressure_matrix(double by) const {
  return coupled::pressure_matrix(at_.domain, at_.numbers, by);
}

std::vector<double> GridFlow::net_flux(const FaceValues& v) const {
  return coupled::net_flux(at_.domain, at_.numbers, v);
}

void GridFlow::add_pressure(std::span<const double> p, double by, FaceValues& v) const {
  coupled::add_pressure(at_.domain, at_.numbers, p, by, v);
}

double GridFlow::kinetic_energy(const FaceValues& v, const FaceValues& w) const {
  return coupled::kinetic_energy(at_.domain, v, w, scene_.density);
}

double GridFlow::prescribed_power(std::span<const double> p, const FaceValues& v) const {
  return coupled::prescribed_power(at_.domain, at_.numbers, p, v);
}

std::vector<double> GridFlow::masses() const {
  std::vector<double> masses;
  for (std::size_t axis = 0; axis < at_.domain.face.size(); ++axis) {
    for (std::size_t f = 0; f < at_.domain.face[axis].size(); ++f)
      masses.push_back(at_.domain.face[axis][f] == FaceKind::open ? scene_.density * at_.domain.volume[axis][f] : 0);
  }
  return masses;
}

/// Measures by what goes through a face over all of its area: through the sliver that a solid leaves of one little
/// does, however fast.
double GridFlow::cells_crossed(const FaceValues& v, double h) const {
  double most = 0;
  for (std::size_t axis = 0; axis < at(scene_.grid.dim); ++axis) {
    for (std::size_t f = 0; f < v[axis].size(); ++f) {
      if (at_.domain.face[axis][f] != FaceKind::closed)
        most = std::max(most, std::abs(v[axis][f]) * at_.domain.area[axis][f] * h / scene_.grid.volume());
    }
  }
  return most;
}

// Smoke.

/// Returns what comes in with fluid: through jets, and through open sides that layers outside lie at.
std::vector<SmokeJet> GridFlow::smoke_sources(double time, double h) const {
  std::vector<SmokeJet> sources = box_.smoke_of_jets(time, h);
  for (int side = 0; side < 2 * scene_.grid.dim && outside_.has_smoke(); ++side) {
    if (!has_fluid_beyond(scene_, side)) continue;
    const int axis = axis_of_side(side);
    each_face_of_side(scene_.grid, side, [&](std::size_t f) {
      if (at_.domain.face[at(axis)][f] != FaceKind::open) return;
      const int row = std::min(scene_.grid.place_of_face(axis, f)[1], scene_.grid.n[1] - 1);
      sources.push_back({axis, f, outside_.density(row), outside_.temperature(row)});
    });
  }
  return sources;
}

Smoke GridFlow::smoke_at_start() const {
  Smoke smoke = clean_smoke(at_.domain);
  const FirstSmoke first = first_smoke(scene_);
  for (std::size_t c = 0; c < first.density.size(); ++c) {
    smoke.smoke[c] = first.density[c] * smoke.volume[c];
    smoke.heat[c] = first.temperature[c] * smoke.volume[c];
  }
  return smoke;
}

void GridFlow::carry_smoke_along(CoupledState& state, double h) const {
  if (!scene_.smoke) return;
  const SmokeFlow flow = carry_smoke(team_, at_.domain, state.v, h, smoke_sources(state.time, h), state.smoke);
  settle_smoke(at_.domain, clean_smoke(at_.domain).volume, state.smoke);  // which has no finer place than cells
  state.smoke_flow.smoke_in += flow.smoke_in, state.smoke_flow.smoke_out += flow.smoke_out;
  state.smoke_flow.heat_in += flow.heat_in, state.smoke_flow.heat_out += flow.heat_out;
}

}  // namespace tether::coupled
