// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/mesh/space_mesher.hpp"

#include <fmt/format.h>

#include "base/diagnostics.hpp"

#ifdef TETHER_TETGEN
#define TETLIBRARY
#include <tetgen.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/numbers.hpp"
#include "physics/box/mesh/boundary_faces.hpp"
#include "physics/box/mesh/lattice_points.hpp"
#endif

namespace tether::coupled {

#ifdef TETHER_TETGEN
namespace {

/// What TetGen is given; it lets go of the lists itself.
void fill(const Outline& outline, std::span<const Outline::Facet> facets, const std::vector<Vec<3>>& points,
          tetgenio& in) {
  in.firstnumber = 0;
  in.numberofpoints = static_cast<int>(outline.places.size() + points.size());
  in.pointlist = new REAL[3 * at(in.numberofpoints)];
  std::size_t k = 0;
  for (const auto* list : {&outline.places, &points}) {
    for (const Vec<3>& x : *list) {
      for (std::size_t a = 0; a < 3; ++a) in.pointlist[k++] = x[a];
    }
  }
  in.numberoffacets = static_cast<int>(facets.size());
  in.facetlist = new tetgenio::facet[facets.size()];
  for (std::size_t f = 0; f < facets.size(); ++f) {
    tetgenio::facet& facet = in.facetlist[f];
    tetgenio::init(&facet);
    facet.numberofpolygons = 1, facet.polygonlist = new tetgenio::polygon[1];
    tetgenio::polygon& polygon = facet.polygonlist[0];
    tetgenio::init(&polygon);
    polygon.numberofvertices = 3, polygon.vertexlist = new int[3];
    for (std::size_t c = 0; c < 3; ++c) polygon.vertexlist[c] = static_cast<int>(facets[f].corners[c]);
  }
  in.numberofholes = static_cast<int>(outline.holes.size());
  in.holelist = new REAL[3 * outline.holes.size()];
  for (std::size_t h = 0; h < outline.holes.size(); ++h) {
    for (std::size_t a = 0; a < 3; ++a) in.holelist[3 * h + a] = outline.holes[h][a];
  }
}

[[noreturn]] void refuse(const Vec<3>& x, const char* why) {
  throw RunError(
      fmt::format("there is no mesh of the fluid near ({:.6g}, {:.6g}, {:.6g}): {}; $contact keeps bodies "
                  "apart, and smaller elements of theirs fit each other better",
                  x[0], x[1], x[2], why));
}

void run(std::string switches, tetgenio& in, tetgenio& out, const Outline& outline) {
  try {
    tetrahedralize(switches.data(), &in, &out);
  } catch (int error) {
    refuse(outline.places.empty() ? Vec<3>{} : outline.places.front(),
           error == 1 ? "it takes more memory than there is" : "TetGen failed on the surfaces there");
  }
}

/// Facets that cross or touch would end the process in the next run. Those of the box's sides touch nothing else.
void check_crossings(const Outline& outline) {
  std::vector<Outline::Facet> facets;
  std::ranges::copy_if(outline.facets, std::back_inserter(facets),
                       [](const Outline::Facet& facet) { return facet.boundary.kind != BoundaryKind::box_side; });
  if (facets.empty()) return;
  tetgenio in, out;
  fill(outline, facets, {}, in);
  run("pdQ", in, out, outline);
  if (out.numberoftrifaces == 0) return;
  Vec<3> x{};
  for (std::size_t a = 0; a < 3; ++a) x[a] = out.pointlist[3 * at(out.trifacelist[0]) + a];
  refuse(x, "the surfaces of bodies or obstacles cross or touch there");
}

/// Puts two empty bits between the bits of a number below 1024.
std::uint32_t spread(std::uint32_t bits) {
  bits = (bits | bits << 16) & 0x030000FF;
  bits = (bits | bits << 8) & 0x0300F00F;
  bits = (bits | bits << 4) & 0x030C30C3;
  return (bits | bits << 2) & 0x09249249;
}

/// TetGen's tetrahedra in an order in which most that are near each other are near in memory, too: along the curve of
/// G. M. Morton (IBM, 1966).
std::vector<std::size_t> along_a_curve(const tetgenio& out) {
  constexpr double places = 1023;
  const std::size_t count = at(out.numberoftetrahedra);
  std::vector<Vec<3>> middle(count);
  Vec<3> low{}, high{};
  for (std::size_t t = 0; t < count; ++t) {
    for (std::size_t k = 0; k < 4; ++k) {
      for (std::size_t a = 0; a < 3; ++a)
        middle[t][a] += 0.25 * out.pointlist[3 * at(out.tetrahedronlist[4 * t + k]) + a];
    }
    if (t == 0) low = high = middle[0];
    for (std::size_t a = 0; a < 3; ++a)
      low[a] = std::min(low[a], middle[t][a]), high[a] = std::max(high[a], middle[t][a]);
  }
  const double width = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
  std::vector<std::pair<std::uint32_t, std::size_t>> order;
  for (std::size_t t = 0; t < count; ++t) {
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

/// The mesh's nodes and tetrahedra. Returns the number of each of TetGen's points; -1: no tetrahedron has it.
std::vector<int> take(const tetgenio& out, FlowMesh& mesh) {
  std::vector<int> number(at(out.numberofpoints), -1);
  for (const std::size_t t : along_a_curve(out)) {
    for (std::size_t k = 4 * t; k < 4 * t + 4; ++k) {
      const auto point = at(out.tetrahedronlist[k]);
      if (number[point] < 0) {
        number[point] = static_cast<int>(mesh.x.size());
        mesh.x.push_back({out.pointlist[3 * point], out.pointlist[3 * point + 1], out.pointlist[3 * point + 2]});
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
  faces.each_left([&](std::size_t f) { refuse(mesh.middle_of_face(f), "TetGen parted the surface there"); });
}

}  // namespace

FlowMesh space_mesh(const Outline& outline, const MeshSizes& sizes) {
  check_crossings(outline);
  tetgenio in, out;
  fill(outline, outline.facets, lattice_points(outline, sizes), in);
  run("pYJq2.0/10Q", in, out, outline);
  FlowMesh mesh;
  mesh.dim = 3;
  const std::vector<int> number = take(out, mesh);
  mesh.find_faces();
  set_boundaries(outline, number, mesh);
  return mesh;
}

#else

FlowMesh space_mesh(const Outline& /*outline*/, const MeshSizes& /*sizes*/) {
  throw RunError("this build makes no tetrahedra: TetGen was not there when it was made");
}

#endif

}  // namespace tether::coupled
