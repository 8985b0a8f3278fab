// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/mesh/mesh_flow.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/diagnostics.hpp"
#include "base/numbers.hpp"
#include "physics/box/closed_regions.hpp"
#include "physics/box/mesh/plane_mesher.hpp"
#include "physics/box/mesh/seals.hpp"
#include "physics/box/mesh/space_mesher.hpp"

namespace tether::coupled {

double pressure_in(const FlowMesh& mesh, std::span<const double> p, std::size_t cell, const Vec<3>& x) {
  const auto shares = mesh.shares(cell, x);
  const auto faces = mesh.faces_of(cell);
  double sum = 0;
  for (std::size_t k = 0; k < faces.size(); ++k) sum += (1 - mesh.dim * shares[k]) * p[at(faces[k])];
  return sum;
}

MeshFlow::MeshFlow(const Coupled& scene, const Vec<3>& gravity, const SolidSurface& surface, std::size_t numbers,
                   Team& team)
    : scene_(scene),
      gravity_(gravity),
      surface_(surface),
      with_obstacles_(scene, surface, numbers),
      team_(team),
      outside_(scene, gravity) {}

// Where the fluid is.

/// Sides that are open to fluid or to nothing, and openings in walls; but not where jets are.
bool MeshFlow::is_open(const FlowMesh& mesh, std::size_t face) const {
  const Boundary& of = mesh.boundary[face];
  if (of.kind != BoundaryKind::box_side) return false;
  const Vec<3> x = mesh.middle_of_face(face);
  if (jet_at(scene_, of.number, x) >= 0) return false;
  if (!is_wall(scene_.sides[at(of.number)])) return true;
  return std::ranges::any_of(scene_.openings, [&](const Opening& opening) {
    return opening.side == of.number && lies_in(opening.patch, of.number, x, scene_.grid.dim);
  });
}

/// No more than a few cells: rooms that bodies shut in as they touch are larger.
double MeshFlow::pocket() const { return std::pow(scene_.mesh->near, scene_.grid.dim); }

/// Bodies that cross shut in parts of the fluid which nothing could leave.
FlowMesh MeshFlow::without_shut_in(FlowMesh mesh) const {
  if (mesh.regions < 2 || surface_.sheets == 0) return mesh;
  std::vector<std::uint8_t> closed(at(mesh.regions), 1);
  for (std::size_t f = 0; f < mesh.faces(); ++f) {
    if (is_open(mesh, f)) closed[at(mesh.region[mesh.cell_of(f)])] = 0;
  }
  const std::vector<double> volumes = mesh.volumes_of(mesh.region, mesh.regions);
  const std::vector<std::uint8_t> pockets = find_pockets(volumes, closed, area_seen(mesh, surface_), pocket());
  return without_regions(std::move(mesh), pockets);
}

/// What bodies that touch walls part stays parted. Where there is no mesh about the solids as they are, their surface
/// is moved back farther where it nearly touches, and then other sizes of cells are tried.
std::shared_ptr<const FlowMesh> MeshFlow::mesh_at(std::span<const double> q) const {
  struct Trial {
    double gap, sizes;  // of those that are asked for
  };
  constexpr std::array trials{Trial{1, 1}, Trial{4, 1}, Trial{16, 1}, Trial{1, 0.8}, Trial{4, 1.25}, Trial{16, 0.6}};
  constexpr double film = 2.5;  // of gaps, between moved sides
  for (std::size_t trial = 0;; ++trial) {
    const double gap = trials[trial].gap * least_gap * scene_.mesh->near;
    const MeshSizes sizes{scene_.mesh->size * trials[trial].sizes, scene_.mesh->near * trials[trial].sizes,
                          scene_.mesh->growth};
    try {
      FlowMesh mesh = scene_.grid.dim == 2 ? plane_mesh(outline_in_plane(scene_, with_obstacles_, q, gap), sizes)
                                           : space_mesh(outline_in_space(scene_, with_obstacles_, q, gap), sizes);
      mesh = without_shut_in(without_seals(std::move(mesh), film * gap, pocket()));
      if (mesh.cells() == 0)
        throw RunError(
            "no cell of the fluid is left: likely cause, bodies that cross each other or the box's sides; $contact "
            "stops them",
            Failure::loses_points);
      return std::make_shared<FlowMesh>(std::move(mesh));
    } catch (const RunError&) {
      if (trial + 1 == trials.size()) throw;
    }
  }
}

/// Of places that are not those of this step or the one before, it is made.
std::shared_ptr<const FlowMesh> MeshFlow::mesh_of(const std::vector<double>& q) const {
  if (at_.mesh && q == at_.q) return at_.mesh;
  return kept_ && q == kept_q_ ? kept_ : mesh_at(q);
}

MeshFlow::Placed MeshFlow::placed(std::span<const double> q) const {
  Placed at_q;
  at_q.q.assign(q.begin(), q.end());
  at_q.mesh = mesh_at(q);
  const FlowMesh& mesh = *at_q.mesh;
  at_q.regions.count = mesh.regions, at_q.regions.closed.assign(at(mesh.regions), 1);
  for (std::size_t f = 0; f < mesh.faces(); ++f) {
    const int region = mesh.region[mesh.cell_of(f)];
    const bool open = is_open(mesh, f);
    at_q.pressures.of.push_back(open ? -1 : static_cast<int>(at_q.pressures.face_of.size()));
    if (open) {
      at_q.regions.closed[at(region)] = 0;
      continue;
    }
    at_q.rows.push_back(at_q.pressures.face_of.size());
    at_q.pressures.face_of.push_back(f), at_q.regions.of.push_back(region);
  }
  at_q.map = map_of(at_q, q);
  if (mesh.dim == 3) at_q.coarse = coarse_of(at_q);
  return at_q;
}

CouplingMap MeshFlow::map_of(const Placed& at_q, std::span<const double> q) const {
  SideSums given(at(surface_.dim));
  for (int side = 0; side < 4 && scene_.grid.dim == 2; ++side) {
    if (!outside_.presses(side)) continue;
    const int axis = axis_of_side(side);
    const double end = is_low_side(side) ? scene_.grid.low[at(axis)] : scene_.grid.high(axis);
    add_beyond(
        surface_, q, axis, end, !is_low_side(side), [&](double y) { return outside_.pressure_beyond(side, y); }, given);
  }
  MapSums sums;
  sums.fluxes.push_back(fluxes_on_mesh(*at_q.mesh, at_q.pressures, surface_, q)), sums.given.push_back(given.take());
  CouplingMap map =
      map_of_sums(team_, surface_, EntriesAt::own_nodes, std::move(sums), at_q.pressures.face_of.size(), q);
  map.area_seen = area_seen(*at_q.mesh, surface_);
  return map;
}

Flow::Equations MeshFlow::equations_at(std::span<const double> q, double by) const {
  Placed at_q = placed(q);
  return {pressure_matrix(at_q, by), std::move(at_q.map.B), std::move(at_q.regions)};
}

void MeshFlow::place(CoupledState& state) {
  at_ = placed(state.q);
  kept_ = mesh_of(state.flow_q), kept_q_ = state.flow_q;
}

// A step.

/// A fluid at rest: the velocity of each cell, after those along x what goes out through each face of a side
/// [volume/time].
FaceValues MeshFlow::still() const {
  FaceValues v;
  for (std::size_t a = 0; a < at(mesh().dim); ++a) v[a].assign(mesh().cells() + (a == 0 ? mesh().faces() : 0), 0.0);
  return v;
}

void MeshFlow::start(CoupledState& state) {
  state.flow_q = state.q;
  place(state);
  state.v = still();
  for (std::size_t a = 0; a < at(mesh().dim); ++a) std::fill_n(state.v[a].begin(), mesh().cells(), scene_.start[a]);
  state.p.assign(at_.mesh->faces(), 0.0);
  if (scene_.viscosity > 0) state.driven = still();
  if (scene_.smoke) start_smoke(state);
}

void MeshFlow::prescribe(double time, double h, FaceValues& v) const {
  const FlowMesh& mesh = *at_.mesh;
  const std::vector<double> speeds = jet_speeds(scene_, time, h);
  for (std::size_t f = 0; f < mesh.faces(); ++f) {
    if (mesh.boundary[f].kind != BoundaryKind::box_side) continue;
    const int jet = jet_at(scene_, mesh.boundary[f].number, mesh.middle_of_face(f));
    v[0][mesh.cells() + f] = jet < 0 ? 0 : -speeds[at(jet)] * mesh.size_of(f);
  }
}

void MeshFlow::add_forces(const Smoke& smoke, double h, FaceValues& v) const {
  const FlowMesh& mesh = *at_.mesh;
  for (std::size_t a = 0; a < at(mesh.dim); ++a) {
    for (std::size_t cell = 0; cell < mesh.cells(); ++cell) v[a][cell] += h * gravity_[a];
  }
  for (std::size_t cell = 0; cell < mesh.cells() && scene_.smoke; ++cell) v[1][cell] += h * buoyancy(smoke, cell);
  each_open_side([&](std::size_t face, std::size_t cell, double p) {
    for (std::size_t a = 0; a < at(mesh.dim); ++a)
      v[a][cell] -= h / scene_.density * p * mesh.area[face][a] / mesh.volume[cell];
  });
}

void MeshFlow::book_forces(CoupledState& state, double h) const {
  const FlowMesh& mesh = *at_.mesh;
  double falling = 0, power = 0, rising = 0;
  for (std::size_t a = 0; a < at(mesh.dim); ++a) {
    for (std::size_t cell = 0; cell < mesh.cells(); ++cell)
      falling += gravity_[a] * mesh.volume[cell] * state.v[a][cell];
  }
  each_open_side([&](std::size_t face, std::size_t cell, double p) {
    for (std::size_t a = 0; a < at(mesh.dim); ++a) power -= p * mesh.area[face][a] * state.v[a][cell];
  });
  for (std::size_t cell = 0; cell < mesh.cells() && scene_.smoke; ++cell)
    rising += buoyancy(state.smoke, cell) * mesh.volume[cell] * state.v[1][cell];
  state.books.gravity += h * scene_.density * falling;
  state.books.buoyancy += h * scene_.density * rising;
  state.books.open_sides += h * power;
}

void MeshFlow::end(const FaceValues& /*change*/, CoupledState& state, double h) {
  const bool moved = state.q != at_.q;
  if (!moved && !scene_.smoke) return;
  Placed next = moved ? placed(state.q) : at_;
  if (scene_.smoke) carry_smoke_to(*next.mesh, h, state);
  kept_ = at_.mesh, kept_q_ = at_.q;  // which the velocity stays on
  at_ = std::move(next);
}

}  // namespace tether::coupled
