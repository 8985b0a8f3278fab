// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/numbers.hpp"
#include "physics/box/mesh/mesh_flow.hpp"

namespace tether::coupled {

// What the friction of a fluid on a mesh does in a step, to itself and to bodies that it sticks to.

/// Walls, obstacles and jets hold what flows along them; sides that slip hold what would flow across.
bool MeshFlow::holds(std::size_t face, int axis) const {
  const Boundary& of = mesh().boundary[face];
  switch (of.kind) {
    case BoundaryKind::none:
    case BoundaryKind::closed:
      return false;
    case BoundaryKind::obstacle:
      return true;
    case BoundaryKind::solid:
      return sticks_to_bodies(scene_);
    case BoundaryKind::box_side:
      break;
  }
  if (at_.pressures.of[face] < 0) return false;
  const bool slips = scene_.sides[at(of.number)] == BoxSide::slip;
  return !slips || axis == axis_of_side(of.number) || jet_at(scene_, of.number, mesh().middle_of_face(face)) >= 0;
}

FaceHolds MeshFlow::face_holds(std::span<const double> q) const {
  FaceHolds holds;
  std::vector<std::uint8_t> has_corner(mesh().x.size(), 0);
  for (std::size_t face = 0; face < mesh().faces(); ++face) {
    for (int a = 0; a < mesh().dim; ++a) holds.held.push_back(this->holds(face, a) ? 1 : 0);
    if (mesh().boundary[face].kind != BoundaryKind::solid || !sticks_to_bodies(scene_)) continue;
    const std::size_t side = at(mesh().boundary[face].number);
    holds.carried.push_back({face, node_shares(surface_, side, q, mesh().middle_of_face(face))});
    for (const int n : mesh().face_nodes(face)) {
      if (std::exchange(has_corner[at(n)], 1) == 0)
        holds.corners.emplace_back(n, node_shares(surface_, side, q, mesh().x[at(n)]));
    }
  }
  return holds;
}

void MeshFlow::begin_friction(const CoupledState& state, NodeInertia nodes, double h) {
  nodes_ = std::move(nodes);
  std::vector<std::size_t> open;
  each_open_side([&](std::size_t face, std::size_t, double) {
    if (scene_.sides[at(mesh().boundary[face].number)] != BoxSide::empty) open.push_back(face);
  });
  rub_with(open, state.q, h);
}

void MeshFlow::rub_with(std::span<const std::size_t> open, std::span<const double> q, double h) {
  rubbing_.emplace(mesh(), face_holds(q), open, scene_.density, scene_.viscosity, nodes_, h);
}

/// A warning once. One velocity across a gap has a third of its friction or less; films of bodies that touch are too
/// thin for what they lack to count.
void MeshFlow::note_narrow_cells(CoupledState& state) {
  constexpr double film = 4;  // of the gaps that bodies leave
  const std::vector<std::size_t> narrow = mesh().cells_across_gaps(film * least_gap * scene_.mesh->near);
  if (narrow.empty()) return;
  if (state.narrow_cells == 0) {
    const Vec<3>& x = mesh().middle(narrow.front());
    messages_.push_back(fmt::format(
        "t = {:.6g}, step {}: cells reach across a gap, as at ({:.4g}, {:.4g}{}): the fluid has a third "
        "of its friction there, or less; by two cells across it has half, by four three quarters: give a smaller "
        "size_near; narrow_cells of summary.txt counts such cells",
        state.time, state.steps + 1, x[0], x[1], mesh().dim == 3 ? fmt::format(", {:.4g}", x[2]) : ""));
  }
  state.narrow_cells = std::max(state.narrow_cells, static_cast<long long>(narrow.size()));
}

/// The velocities of faces that jets hold; 0 of others.
std::vector<double> MeshFlow::given_at_faces(const FaceValues& v) const {
  const std::size_t dim = at(mesh().dim);
  std::vector<double> given(mesh().faces() * dim, 0.0);
  each_prescribed(v, [&](std::size_t face, double out) {
    const double square = dot(mesh().area[face], mesh().area[face]);
    for (std::size_t a = 0; a < dim; ++a) given[face * dim + a] = out * mesh().area[face][a] / square;
  });
  return given;
}

/// The solids get at (4) what the fluid's friction gave their nodes, as a force that acts all the step.
std::vector<double> MeshFlow::add_friction(CoupledState& state, double h, double tolerance, std::span<double> drag) {
  const std::span<const double> u =
      sticks_to_bodies(scene_) ? std::span<const double>(state.u) : std::span<const double>();
  const std::vector<double> given = given_at_faces(state.v);
  Rubbed rubbed = rubbing_->act(team_, u, state.driven_nodes, tolerance, given, state.driven, state.v);
  if (rubbed.iterations < 0) {  // solids at open sides may take the sign of its power
    rub_with({}, state.q, h);
    rubbed = rubbing_->act(team_, u, state.driven_nodes, tolerance, given, state.driven, state.v);
  }
  rubbed.book(h, state, drag);
  return std::move(rubbed.nodes);
}

void MeshFlow::take_drive(const FaceValues& change, double h, CoupledState& state) const {
  for (std::size_t a = 0; a < at(mesh().dim); ++a) {
    for (std::size_t cell = 0; cell < mesh().cells(); ++cell) state.driven[a][cell] = change[a][cell] / h;
  }
}

/// That of the cell of the mesh before which is at a cell's middle; where the mesh is the same it is the same.
FaceValues MeshFlow::drive_from(const CellFinder& finder, const FaceValues& before) const {
  FaceValues drive = still();
  std::size_t from = 0;
  for (std::size_t cell = 0; cell < mesh().cells(); ++cell) {
    Vec<3> x = mesh().middle(cell);
    from = finder.cell_at(x, from);
    for (std::size_t a = 0; a < at(mesh().dim); ++a) drive[a][cell] = before[a][from];
  }
  return drive;
}

/// A face's flux is that out of its cells; about it is the volume that its part of them has.
void MeshFlow::add_viscous_pressure(double h, std::span<double> missed) const {
  FaceValues of_cells = still(), more = of_cells;
  auto next = missed.begin();
  for (std::vector<double>& along : of_cells) {
    for (double& value : along) value = *next++;
  }
  std::vector<double> p = net_flux(of_cells);
  for (std::size_t k = 0; k < p.size(); ++k) {
    double volume = 0;
    for (const int c : mesh().cells_of_face[at_.pressures.face_of[k]]) {
      if (c >= 0) volume += mesh().volume[at(c)] / static_cast<double>(mesh().corners());
    }
    p[k] *= 2 * h * scene_.viscosity / volume;
  }
  add_pressure(p, 1 / scene_.density, more);
  next = missed.begin();
  for (const std::vector<double>& along : more) {
    for (const double value : along) *next++ += value;
  }
}

}  // namespace tether::coupled
