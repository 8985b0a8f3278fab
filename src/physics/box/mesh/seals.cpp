// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/mesh/seals.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/numbers.hpp"
#include "physics/box/mesh/boundary_faces.hpp"

namespace tether::coupled {
namespace {

/// Low cells between two parts of the boundary: in the plane one of their sides lies on it, in space all of their
/// nodes.
std::vector<std::uint8_t> films_of(const FlowMesh& mesh, double height) {
  std::vector<std::uint8_t> film;
  const std::vector<std::uint8_t> at_boundary = mesh.nodes_at_boundary();
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
    const double largest = mesh.largest_face(cell);
    double along = 0;  // of those at the boundary
    for (const int f : mesh.faces_of(cell)) {
      if (mesh.is_at_boundary(at(f))) along = std::max(along, mesh.size_of(at(f)));
    }
    const bool between = mesh.dim == 2
                             ? 2 * along > largest
                             : std::ranges::all_of(mesh.nodes_of(cell), [&](int n) { return at_boundary[at(n)] != 0; });
    const bool tiny = mesh.volume[cell] < std::pow(height, mesh.dim);  // as where a film ends
    film.push_back(tiny || (between && mesh.dim * mesh.volume[cell] < height * largest) ? 1 : 0);
  }
  return film;
}

/// Counts parts of the fluid that are no larger as films.
void add_small_rooms(const FlowMesh& mesh, double most, std::vector<std::uint8_t>& film) {
  const FlowMesh::Parts rooms = mesh.parts_of(film, 0);
  const std::vector<double> volumes = mesh.volumes_of(rooms.of, rooms.count);
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
    if (rooms.of[cell] >= 0 && volumes[at(rooms.of[cell])] <= most) film[cell] = 1;
  }
}

/// The same cells but those marked, whose faces are closed.
FlowMesh without(const FlowMesh& mesh, const std::vector<std::uint8_t>& left_out) {
  FlowMesh kept;
  kept.dim = mesh.dim;
  std::vector<int> number(mesh.x.size(), -1);
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
    if (left_out[cell] != 0) continue;
    for (const int n : mesh.nodes_of(cell)) {
      if (number[at(n)] < 0) number[at(n)] = static_cast<int>(kept.x.size()), kept.x.push_back(mesh.x[at(n)]);
      kept.nodes.push_back(number[at(n)]);
    }
  }
  kept.find_faces();
  BoundaryFaces faces(kept);
  for (std::size_t f = 0; f < mesh.faces(); ++f) {
    if (!mesh.is_at_boundary(f)) continue;
    BoundaryFaces::Nodes nodes{-1, -1, -1};
    std::ranges::transform(mesh.face_nodes(f), nodes.begin(), [&](int n) { return number[at(n)]; });
    faces.set(nodes, mesh.boundary[f]);
  }
  faces.close_left();
  return kept;
}

}  // namespace

FlowMesh without_seals(FlowMesh mesh, double height, double pocket) {
  std::vector<std::uint8_t> film = films_of(mesh, height);
  if (std::ranges::count(film, 1) == 0) return mesh;
  add_small_rooms(mesh, pocket, film);
  const FlowMesh::Parts rooms = mesh.parts_of(film, 0), films = mesh.parts_of(film, 1);
  if (rooms.count < 2) return mesh;
  std::vector<int> joins(at(films.count), -1);  // the first room that each film meets
  std::vector<std::uint8_t> seals(at(films.count), 0), left_out(mesh.cells(), 0);
  for (std::size_t f = 0; f < mesh.faces(); ++f) {
    if (mesh.is_at_boundary(f)) continue;
    auto [a, b] = mesh.cells_of_face[f];
    if (film[at(a)] == film[at(b)]) continue;
    if (film[at(a)] == 0) std::swap(a, b);
    int& first = joins[at(films.of[at(a)])];
    if (first < 0) first = rooms.of[at(b)];
    if (first != rooms.of[at(b)]) seals[at(films.of[at(a)])] = 1;
  }
  if (std::ranges::count(seals, 1) == 0) return mesh;
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell)
    left_out[cell] = films.of[cell] >= 0 ? seals[at(films.of[cell])] : 0;
  return without(mesh, left_out);
}

FlowMesh without_regions(FlowMesh mesh, std::span<const std::uint8_t> marked) {
  if (std::ranges::count(marked, 1) == 0) return mesh;
  std::vector<std::uint8_t> left_out;
  for (const int region : mesh.region) left_out.push_back(marked[at(region)]);
  return without(mesh, left_out);
}

}  // namespace tether::coupled
