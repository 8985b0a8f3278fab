// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/mesh/space_mesher.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/numbers.hpp"
#include "physics/box/mesh/boundary_faces.hpp"
#include "physics/box/mesh/lattice_points.hpp"
#include "physics/box/mesh/tetrahedra.hpp"

namespace tether::coupled {
namespace {

/// Puts two empty bits between the bits of a number below 1024.
std::uint32_t spread(std::uint32_t bits) {
  bits = (bits | bits << 16) & 0x030000FF;
  bits = (bits | bits << 8) & 0x0300F00F;
  bits = (bits | bits << 4) & 0x030C30C3;
  return (bits | bits << 2) & 0x09249249;
}

/// Tetrahedra in an order in which most that are near each other are near in memory, too: along the curve of
/// G. M. Morton (IBM, 1966).
std::vector<std::size_t> along_a_curve(const Tetrahedra& made) {
  constexpr double places = 1023;
  std::vector<Vec<3>> middle(made.count());
  Vec<3> low{}, high{};
  for (std::size_t t = 0; t < made.count(); ++t) {
    for (std::size_t k = 0; k < 4; ++k) {
      for (std::size_t a = 0; a < 3; ++a) middle[t][a] += 0.25 * made.x[at(made.nodes[4 * t + k])][a];
    }
    if (t == 0) low = high = middle[0];
    for (std::size_t a = 0; a < 3; ++a)
      low[a] = std::min(low[a], middle[t][a]), high[a] = std::max(high[a], middle[t][a]);
  }
  const double width = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
  std::vector<std::pair<std::uint32_t, std::size_t>> order;
  for (std::size_t t = 0; t < made.count(); ++t) {
    std::uint32_t place = 0;
    for (std::size_t a = 0; a < 3 && width > 0; ++a)
      place |= spread(static_cast<std::uint32_t>((middle[t][a] - low[a]) / width * places)) << a;
    order.emplace_back(place, t);
  }
  std::ranges::sort(order);
  std::vector<std::size_t> tetrahedra;
  for (const auto& [place, t] : order) tetrahedra.push_back(t);
  return tetrahedra;
}

/// The mesh's nodes and tetrahedra. Returns the number of each of the points; -1: no tetrahedron has it.
std::vector<int> take(const Tetrahedra& made, FlowMesh& mesh) {
  std::vector<int> number(made.x.size(), -1);
  for (const std::size_t t : along_a_curve(made)) {
    for (std::size_t k = 4 * t; k < 4 * t + 4; ++k) {
      const auto point = at(made.nodes[k]);
      if (number[point] < 0) {
        number[point] = static_cast<int>(mesh.x.size());
        mesh.x.push_back(made.x[point]);
      }
      mesh.nodes.push_back(number[point]);
    }
  }
  return number;
}

/// Facets whose corners are among those numbers.
void set_boundaries(const Outline& outline, std::span<const int> number, FlowMesh& mesh) {
  BoundaryFaces faces(mesh);
  for (const Outline::Facet& facet : outline.facets) {
    const auto& of = facet.corners;
    faces.set({number[of[0]], number[of[1]], number[of[2]]}, facet.boundary);
  }
  faces.each_left([&](std::size_t f) { refuse_mesh(mesh.middle_of_face(f), "TetGen parted the surface there"); });
}

}  // namespace

FlowMesh space_mesh(const Outline& outline, const MeshSizes& sizes) {
  FlowMesh mesh;
  mesh.dim = 3;
  const std::vector<int> number = take(tetrahedra_in(outline, lattice_points(outline, sizes)), mesh);
  mesh.find_faces();
  set_boundaries(outline, number, mesh);
  return mesh;
}

}  // namespace tether::coupled
