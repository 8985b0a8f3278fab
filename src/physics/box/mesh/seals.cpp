// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/mesh/seals.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "base/numbers.hpp"

namespace tether::coupled {
namespace {

/// Low cells between two parts of the boundary: in the plane one of their sides lies on it, in space all of their
/// nodes.
std::vector<std::uint8_t> films_of(const FlowMesh& mesh, double height) {
  std::vector<std::uint8_t> film, at_boundary(mesh.x.size(), 0);
  for (std::size_t f = 0; f < mesh.faces(); ++f) {
    if (!mesh.is_at_boundary(f)) continue;
    for (const int n : mesh.face_nodes(f)) at_boundary[at(n)] = 1;
  }
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
    double largest = 0, along = 0;  // of all faces, and of those at the boundary
    for (const int f : mesh.faces_of(cell)) {
      largest = std::max(largest, mesh.size_of(at(f)));
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

/// Numbers the parts of the cells of a kind, which faces between two of that kind join; -1 for others.
std::vector<int> parts_of(const FlowMesh& mesh, const std::vector<std::uint8_t>& film, std::uint8_t kind, int& count) {
  std::vector<int> part(mesh.cells(), -1);
  std::vector<std::size_t> next;
  count = 0;
  for (std::size_t first = 0; first < mesh.cells(); ++first) {
    if (film[first] != kind || part[first] >= 0) continue;
    part[first] = count, next.push_back(first);
    while (!next.empty()) {
      const std::size_t cell = next.back();
      next.pop_back();
      for (const int f : mesh.faces_of(cell)) {
        for (const int other : mesh.cells_of_face[at(f)]) {
          if (other < 0 || film[at(other)] != kind || part[at(other)] >= 0) continue;
          part[at(other)] = count, next.push_back(at(other));
        }
      }
    }
    ++count;
  }
  return part;
}

std::vector<int> sorted_nodes(const FlowMesh& mesh, std::size_t face) {
  const auto nodes = mesh.face_nodes(face);
  std::vector<int> sorted(nodes.begin(), nodes.end());
  std::sort(sorted.begin(), sorted.end());
  return sorted;
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
  std::map<std::vector<int>, Boundary> boundaries;
  for (std::size_t f = 0; f < mesh.faces(); ++f) {
    if (!mesh.is_at_boundary(f)) continue;
    std::vector<int> nodes = sorted_nodes(mesh, f);
    for (int& n : nodes) n = number[at(n)];
    std::sort(nodes.begin(), nodes.end());
    boundaries[nodes] = mesh.boundary[f];
  }
  for (std::size_t f = 0; f < kept.faces(); ++f) {
    if (!kept.is_at_boundary(f)) continue;
    const auto found = boundaries.find(sorted_nodes(kept, f));
    kept.boundary[f] = found == boundaries.end() ? Boundary{BoundaryKind::closed, -1} : found->second;
  }
  return kept;
}

}  // namespace

FlowMesh without_seals(FlowMesh mesh, double height) {
  const std::vector<std::uint8_t> film = films_of(mesh, height);
  if (std::ranges::count(film, 1) == 0) return mesh;
  int rooms = 0, films = 0;
  const std::vector<int> room = parts_of(mesh, film, 0, rooms), of_film = parts_of(mesh, film, 1, films);
  if (rooms < 2) return mesh;
  std::vector<int> joins(at(films), -1);  // the first room that each film meets
  std::vector<std::uint8_t> seals(at(films), 0), left_out(mesh.cells(), 0);
  for (std::size_t f = 0; f < mesh.faces(); ++f) {
    if (mesh.is_at_boundary(f)) continue;
    auto [a, b] = mesh.cells_of_face[f];
    if (film[at(a)] == film[at(b)]) continue;
    if (film[at(a)] == 0) std::swap(a, b);
    int& first = joins[at(of_film[at(a)])];
    if (first < 0) first = room[at(b)];
    if (first != room[at(b)]) seals[at(of_film[at(a)])] = 1;
  }
  if (std::ranges::count(seals, 1) == 0) return mesh;
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell)
    left_out[cell] = of_film[cell] >= 0 ? seals[at(of_film[cell])] : 0;
  return without(mesh, left_out);
}

}  // namespace tether::coupled
