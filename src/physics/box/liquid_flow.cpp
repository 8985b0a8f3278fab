// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/liquid_flow.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "physics/box/cut_faces.hpp"
#include "physics/box/liquid/extend.hpp"
#include "physics/box/liquid/move.hpp"
#include "physics/box/liquid/parts.hpp"
#include "physics/box/liquid/seed.hpp"
#include "physics/box/liquid/settle.hpp"
#include "physics/box/matrix.hpp"
#include "physics/box/projection.hpp"

namespace tether::coupled {

void LiquidFlow::fill(CoupledState& state) {
  Room room = placer_.room_at(state.q);
  std::vector<int> without;
  state.particles = liquid::seed(scene_, room.domain, near_solids(room), &without);
  for (const int number : without)
    messages_.push_back(fmt::format("region {} of liquid is too thin for the cells: it has no particle", number));
  state.liquid_flow = liquid_.no_flow();
  state.full = 1;
  liquid_.look(state.liquid_flow, state.particles);
  take(placer_.in(std::move(room), state.q, liquid_.filled()));
  liquid_.give_to_faces(at_.room(), state.particles, state.v);
  liquid_.note_speeds(state.v);
  note_air(state);
}

/// The volumes of closed regions are those of the start only while liquid fills all of the room.
void LiquidFlow::note_air(CoupledState& state) const {
  const auto& distance = at_.surface->distance;
  for (std::size_t c = 0; c < distance.size() && state.full != 0; ++c)
    state.full = at_.room().kind[c] == CellKind::fluid && distance[c] >= 0 ? 0 : 1;
}

/// The particles have carried the velocity along; the faces get it back from them.
void LiquidFlow::begin(CoupledState& state, double h) {
  before_ = books_of(state);
  liquid_.give_to_faces(at_.room(), state.particles, state.v);
  prescribe(state.time, h, state.v);
  liquid_.note_speeds(state.v);
}

void LiquidFlow::place(CoupledState& state) {
  liquid_.look(state.liquid_flow, state.particles);
  take(placed(state.q));
}

void LiquidFlow::finish_start(double h, CoupledState& state) {
  GridFlow::finish_start(h, state);
  move_particles(state, 0);
}

void LiquidFlow::end(const FaceValues& change, CoupledState& state, double h) {
  end_velocities(change, h, state);
  move_particles(state, h);
  place_moved(state.time + h, state);
  book(state);
}

void LiquidFlow::extend(double h, double cells_crossed, FaceValues& v) const {
  if (scene_.coupling.cuts_faces) blend_cut_faces(at_.domain, at_.room(), h, v);
  liquid_.extend(at_, cells_crossed, v);
}

void LiquidFlow::move_particles(CoupledState& state, double h) {
  double fastest = 0;  // of the bodies' nodes, along an axis
  for (const double u : state.u) fastest = std::max(fastest, std::abs(u));
  const liquid::CarriedEnergy carried =
      liquid_.carry(at_, state.v, 2 * fastest + h * std::sqrt(dot(gravity_, gravity_)),
                    jet_speeds(scene_, state.time, h), h, state.particles, state.liquid_flow);
  state.books.jets += carried.in, state.books.open_sides -= carried.out;
}

LiquidFlow::Books LiquidFlow::books_of(const CoupledState& state) const {
  const EnergyBooks& books = state.books;
  return {liquid_.energy(state.particles),
          books.jets + books.open_sides - books.viscous - books.projected - books.sources};
}

/// What is neither exchanged nor booked elsewhere the method lost, by carrying particles along and spreading them.
void LiquidFlow::book(CoupledState& state) const {
  const Books now = books_of(state);
  state.books.advected += before_.energy - now.energy + now.booked - before_.booked - state.last.gave;
}

/// The solids have moved, too: what they came over is put out of them, and what crowds is spread before the surface is
/// found.
void LiquidFlow::place_after_step(CoupledState& state) {
  Room room = placer_.room_at(state.q);
  const liquid::NearSolids solids = near_solids(room);
  liquid::put_out_of_solids(team_, scene_.grid, solids, state.u, state.particles);
  settle_particles(room, state);
  liquid::put_out_of_solids(team_, scene_.grid, solids, state.u, state.particles);
  liquid_.look(state.liquid_flow, state.particles);
  take(placer_.in(std::move(room), state.q, liquid_.filled()));
  note_air(state);
}

liquid::NearSolids LiquidFlow::near_solids(const Room& room) const {
  return {placer_.whole().surface(), room.places, scene_.grid, room.crossings};
}

/// Moves particles, not velocities, by the ways w of a field whose divergence takes off what is too much in a cell, and
/// which ends at the surface as pressures do.
void LiquidFlow::settle_particles(const Room& room, CoupledState& state) {
  constexpr double tolerance = 1e-3, most = 0.3;  // of its solution; cells
  liquid_.look(state.liquid_flow, state.particles);
  const std::vector<double> distance = liquid::surface_distances(scene_.grid, liquid_.filled(), room.open);
  const FlowDomain domain = liquid::liquid_in(room.domain, distance, scene_.liquid->air);
  const PressureNumbers numbers = number_pressures(domain);
  const std::vector<double> out = liquid::crowding(scene_.grid, distance, room.open, numbers, liquid_.filled());
  const CouplingMatrix none(static_cast<std::int64_t>(out.size()), static_cast<std::int64_t>(state.u.size()));
  const std::vector<int> region = of_cells(numbers, domain.region);
  const std::vector<std::uint8_t> closed = closed_regions(domain);
  std::vector<double> p(out.size(), 0.0);
  system_.solve_sources({solids_.A, solids_.b, none, none, coupled::pressure_matrix(domain, numbers, 1), out,
                         solids_.held, numbers.cell, domain.kind.size(), region, closed, closed},
                        state.time, tolerance, p);
  FaceValues ways = face_values(domain.grid);
  coupled::add_pressure(domain, numbers, p, 1, ways);
  liquid::extend_about_liquid(room.domain, domain, distance, face_values(domain.grid), 2, ways);
  liquid::shift_particles(team_, room.domain, ways, most, state.particles);
}

void LiquidFlow::find_parts() { parts_ = liquid::liquid_parts(scene_.grid, at_.surface->distance); }

/// About a liquid faces get it from those in it, as they get their velocities: they may be in it by then.
void LiquidFlow::extend_drive(CoupledState& state) const {
  constexpr int layers = 2;
  liquid::extend_about_liquid(at_.room(), at_.domain, at_.surface->distance, face_values(scene_.grid), layers,
                              state.driven);
}

/// Faces that no pressure moves but that have liquid keep what friction made of their velocity, with the acceleration
/// of those in the liquid: on, not along a line through these, whose slope is that of the stress below the surface.
void LiquidFlow::keep_rubbed_faces(const FaceValues& given, const FaceValues& change, double h,
                                   CoupledState& state) const {
  for (int axis = 0; axis < scene_.grid.dim; ++axis) {
    for (std::size_t f = 0; f < state.v[at(axis)].size(); ++f) {
      if (at_.room().face[at(axis)][f] != FaceKind::open || at_.domain.face[at(axis)][f] == FaceKind::open) continue;
      if (part_of_face(parts_, scene_.grid, axis, scene_.grid.place_of_face(axis, f)) == 0) continue;
      state.v[at(axis)][f] = given[at(axis)][f] - change[at(axis)][f] + h * state.driven[at(axis)][f];
    }
  }
}

}  // namespace tether::coupled
