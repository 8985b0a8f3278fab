// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "physics/box/liquid/extend.hpp"
#include "physics/box/liquid/move.hpp"
#include "physics/box/liquid/seed.hpp"
#include "physics/box/liquid/settle.hpp"
#include "physics/box/matrix.hpp"
#include "physics/box/projection.hpp"
#include "physics/box/step.hpp"

namespace tether::coupled {

// What a step does with the particles of a liquid.

void CoupledStep::fill_with_liquid(CoupledState& state) {
  Room room = placer_.room_at(state.q);
  std::vector<int> without;
  state.particles = liquid::seed(coupled_, room.domain, near_solids(room), &without);
  for (const int number : without)
    messages_.push_back(fmt::format("region {} of liquid is too thin for the cells: it has no particle", number));
  state.liquid_flow = liquid_->no_flow();
  state.full = 1;
  liquid_->look(state.liquid_flow, state.particles);
  at_ = placer_.in(std::move(room), state.q, {}, liquid_->filled());
  liquid_->give_to_faces(at_.room(), state.particles, state.v);
  liquid_->note_speeds(state.v);
  note_air(state);
}

/// The volumes of closed regions are those of the start only while liquid fills all of the room.
void CoupledStep::note_air(CoupledState& state) const {
  const auto& distance = at_.surface->distance;
  for (std::size_t c = 0; c < distance.size() && state.full != 0; ++c)
    state.full = at_.room().kind[c] == CellKind::fluid && distance[c] >= 0 ? 0 : 1;
}

/// The particles have carried the velocity along; the faces get it back from them.
void CoupledStep::take_from_particles(CoupledState& state, double h) {
  liquid_->give_to_faces(at_.room(), state.particles, state.v);
  box_.prescribe(at_.domain, state.time, h, state.v);
  liquid_->note_speeds(state.v);
}

void CoupledStep::move_particles(CoupledState& state, double h) {
  double fastest = 0;  // of the bodies' nodes, along an axis
  for (const double u : state.u) fastest = std::max(fastest, std::abs(u));
  const liquid::CarriedEnergy carried =
      liquid_->carry(at_, state.v, 2 * fastest + h * std::sqrt(dot(gravity_, gravity_)), box_.jet_speeds(state.time, h),
                     h, state.particles, state.liquid_flow);
  state.books.jets += carried.in, state.books.open_sides -= carried.out;
}

CoupledStep::LiquidBooks CoupledStep::books_of_liquid(const CoupledState& state) const {
  const EnergyBooks& books = state.books;
  return {liquid_->energy(state.particles),
          books.jets + books.open_sides - books.viscous - books.projected - books.sources};
}

/// What is neither exchanged nor booked elsewhere the method lost, by carrying particles along and spreading them.
void CoupledStep::book_liquid(const LiquidBooks& before, CoupledState& state) const {
  const LiquidBooks now = books_of_liquid(state);
  state.books.advected += before.energy - now.energy + now.booked - before.booked - state.last.gave;
}

/// The solids have moved, too: what they came over is put out of them, and what crowds is spread before the surface is
/// found.
void CoupledStep::place_liquid(CoupledState& state) {
  Room room = placer_.room_at(state.q);
  const liquid::NearSolids solids = near_solids(room);
  liquid::put_out_of_solids(team_, coupled_.grid, solids, state.u, state.particles);
  settle_particles(room, state);
  liquid::put_out_of_solids(team_, coupled_.grid, solids, state.u, state.particles);
  liquid_->look(state.liquid_flow, state.particles);
  at_ = placer_.in(std::move(room), state.q, {}, liquid_->filled());
  note_air(state);
}

liquid::NearSolids CoupledStep::near_solids(const Room& room) const {
  return {placer_.whole().surface(), room.places, coupled_.grid, room.crossings};
}

/// Moves particles, not velocities, by the ways w of a field whose divergence takes off what is too much in a cell, and
/// which ends at the surface as pressures do.
void CoupledStep::settle_particles(const Room& room, CoupledState& state) {
  constexpr double tolerance = 1e-3, most = 0.3;  // of its solution; cells
  liquid_->look(state.liquid_flow, state.particles);
  const std::vector<double> distance = liquid::surface_distances(coupled_.grid, liquid_->filled(), room.open);
  const FlowDomain domain = liquid::liquid_in(room.domain, distance, coupled_.liquid->air);
  const PressureNumbers numbers = number_pressures(domain);
  const std::vector<double> out = liquid::crowding(coupled_.grid, distance, room.open, numbers, liquid_->filled());
  const CouplingMatrix none(static_cast<std::int64_t>(out.size()), static_cast<std::int64_t>(state.u.size()));
  const std::vector<int> region = of_cells(numbers, domain.region);
  const std::vector<std::uint8_t> closed = closed_regions(domain);
  std::vector<double> p(out.size(), 0.0);
  system_.solve_sources({solids_.A, solids_.b, none, none, pressure_matrix(domain, numbers, 1), out, solids_.held,
                         numbers.cell, domain.kind.size(), region, closed, closed},
                        state.time, tolerance, p);
  FaceValues ways = face_values(domain.grid);
  add_pressure(domain, numbers, p, 1, ways);
  liquid::extend_about_liquid(room.domain, domain, distance, face_values(domain.grid), 2, ways);
  liquid::shift_particles(team_, room.domain, ways, most, state.particles);
}

}  // namespace tether::coupled
