// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/numbers.hpp"
#include "physics/box/mesh/mesh_flow.hpp"

// How a step's fluid brings its velocity from the mesh before.

namespace tether::coupled {

void MeshFlow::begin(CoupledState& state, double h) {
  kept_ = mesh_of(state.flow_q), kept_q_ = state.flow_q;
  const FlowMesh& old = *kept_;
  const FlowMesh& mesh = *at_.mesh;
  const double before = kinetic_energy_on(old, state.v, state.v);
  Carried carried{still(), still()};
  prescribe(state.time, h, carried.v);
  const MeshVelocity velocity(old, state.v);
  const std::vector<double> speeds = jet_speeds(scene_, state.time, h);
  const auto met = [&](const MeshVelocity::Origin& origin, Vec<3> v) {
    if (origin.opened_at >= 0) v = velocity_of_solid(old, at(origin.opened_at), state.u, v);
    return origin.face >= 0 ? jet_velocity(origin, old, speeds, v) : v;
  };
  carry_to(mesh, velocity, h, met, carried);
  hold_energy(mesh, 2 / scene_.density * most_energy(before, carried_in_by(carried.v, h), state), carried);
  state.p = pressures_on_faces(velocity.finder(), old, state.p);
  if (scene_.viscosity > 0) {
    state.driven = drive_from(velocity.finder(), state.driven);
    note_narrow_cells(state);
  }
  state.v = std::move(carried.v), state.flow_q = state.q;
  const CarriedIn in = carried_in_by(state.v, h);
  state.books.jets += in.jets, state.books.open_sides += in.open_sides;
  state.books.advected += before + in.jets + in.open_sides - kinetic_energy(state.v, state.v);
}

/// Carrying may give back what it and the pressures have lost of the fluid's energy in the last steps, but no more than
/// a part of what there is: a flow that turns gains by the one and loses by the other. With more, the errors of a
/// coarse mesh would let flows in closed rooms grow without end.
double MeshFlow::most_energy(double before, const CarriedIn& in, CoupledState& state) {
  constexpr double of_energy = 0.01;
  const double lost = state.books.advected + state.books.projected;
  state.lost_for_good = std::clamp(state.lost_for_good, lost - of_energy * before, lost);
  return before + in.jets + in.open_sides + lost - state.lost_for_good;
}

/// First guesses of this mesh's pressures from those of the one before.
std::vector<double> MeshFlow::pressures_on_faces(const CellFinder& finder, const FlowMesh& old,
                                                 std::span<const double> p) const {
  std::vector<double> found;
  std::size_t cell = 0;
  for (std::size_t f = 0; f < at_.mesh->faces(); ++f) {
    Vec<3> x = at_.mesh->middle_of_face(f);
    cell = finder.cell_at(x, cell);
    found.push_back(pressure_in(old, p, cell, x));
  }
  return found;
}

/// What goes through a face has the velocity of its cell, but for what jets blow in, which goes across the face.
CarriedIn MeshFlow::carried_in_by(const FaceValues& v, double h) const {
  const FlowMesh& mesh = *at_.mesh;
  const auto square_in = [&](std::size_t face) {
    double square = 0;
    for (std::size_t a = 0; a < at(mesh.dim); ++a) square += std::pow(v[a][mesh.cell_of(face)], 2);
    return square;
  };
  const auto energy = [&](double out, double square) { return -0.5 * scene_.density * h * out * square; };
  CarriedIn in;
  each_prescribed(v, [&](std::size_t face, double out) {
    in.jets += energy(out, out > 0 ? square_in(face) : std::pow(out / mesh.size_of(face), 2));
  });
  each_open_side([&](std::size_t face, std::size_t cell, double) {
    double out = 0;
    for (std::size_t a = 0; a < at(mesh.dim); ++a) out += mesh.area[face][a] * v[a][cell];
    in.open_sides += energy(out, square_in(face));
  });
  return in;
}

/// The velocity of the solid that a cell lies at; that of the fluid where it lies at none. Where a solid has made room
/// the fluid follows it: what was next to it, in a film that was thin, may be far too fast for all of that room.
Vec<3> MeshFlow::velocity_of_solid(const FlowMesh& old, std::size_t cell, std::span<const double> u,
                                   const Vec<3>& fluid) const {
  for (const int f : old.faces_of(cell)) {
    if (old.boundary[at(f)].kind != BoundaryKind::solid) continue;
    Vec<3> v{};
    const auto nodes = surface_.side(at(old.boundary[at(f)].number));
    for (const int n : nodes) {
      for (std::size_t a = 0; a < at(old.dim); ++a)
        v[a] += u[at(n) * at(old.dim) + a] / static_cast<double>(nodes.size());
    }
    return v;
  }
  return fluid;
}

/// The velocity of the jet that a path began in; that of the fluid where it is none that blows in.
Vec<3> MeshFlow::jet_velocity(const MeshVelocity::Origin& origin, const FlowMesh& old, std::span<const double> speeds,
                              const Vec<3>& fluid) const {
  const Boundary& met = old.boundary[at(origin.face)];
  const int jet = met.kind == BoundaryKind::box_side ? jet_at(scene_, met.number, origin.x) : -1;
  if (jet < 0 || speeds[at(jet)] <= 0) return fluid;
  Vec<3> v{};
  v[at(axis_of_side(met.number))] = (is_low_side(met.number) ? 1 : -1) * speeds[at(jet)];
  return v;
}

}  // namespace tether::coupled
