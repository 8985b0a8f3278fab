// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/mesh/tetrahedra.hpp"

#include <fmt/format.h>

#include "base/diagnostics.hpp"

#ifdef TETHER_TETGEN
#define TETLIBRARY
#include <tetgen.h>

#include <algorithm>
#include <cstring>
#include <iterator>

#include "base/child.hpp"
#include "base/numbers.hpp"
#endif

namespace tether::coupled {

void refuse_mesh(const Vec<3>& x, const std::string& why) {
  throw RunError(
      fmt::format("there is no mesh of the fluid near ({:.6g}, {:.6g}, {:.6g}): {}; obstacles must stand "
                  "apart, $contact keeps bodies apart, and smaller elements of theirs fit each other better",
                  x[0], x[1], x[2], why));
}

#ifdef TETHER_TETGEN
namespace {

/// What TetGen is given; it lets go of the lists itself.
void fill(const Outline& outline, std::span<const Outline::Facet> facets, std::span<const Vec<3>> points,
          tetgenio& in) {
  in.firstnumber = 0;
  in.numberofpoints = static_cast<int>(outline.places.size() + points.size());
  in.pointlist = new REAL[3 * at(in.numberofpoints)];
  std::size_t k = 0;
  for (const std::span<const Vec<3>> list : {std::span<const Vec<3>>(outline.places), points}) {
    for (const Vec<3>& x : list) {
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

/// What the process that makes tetrahedra sends before them.
struct Head {
  enum { made, crossing, no_memory } ending = made;
  Vec<3> place{};  // of a crossing
  std::size_t points = 0, numbers = 0;
};

std::string bytes_of(const Head& head, const tetgenio& out) {
  std::string bytes(reinterpret_cast<const char*>(&head), sizeof head);
  bytes.append(reinterpret_cast<const char*>(out.pointlist), head.points * sizeof(Vec<3>));
  bytes.append(reinterpret_cast<const char*>(out.tetrahedronlist), head.numbers * sizeof(int));
  return bytes;
}

/// Facets that cross or touch would end the process in the next run. Those of the box's sides touch nothing else.
bool find_crossing(const Outline& outline, Vec<3>& place) {
  std::vector<Outline::Facet> facets;
  std::ranges::copy_if(outline.facets, std::back_inserter(facets),
                       [](const Outline::Facet& facet) { return facet.boundary.kind != BoundaryKind::box_side; });
  if (facets.empty()) return false;
  tetgenio in, out;
  fill(outline, facets, {}, in);
  std::string switches = "pdQ";
  tetrahedralize(switches.data(), &in, &out);
  if (out.numberoftrifaces == 0) return false;
  for (std::size_t a = 0; a < 3; ++a) place[a] = out.pointlist[3 * at(out.trifacelist[0]) + a];
  return true;
}

std::string make(const Outline& outline, std::span<const Vec<3>> points) {
  Head head;
  tetgenio in, out;
  try {
    if (find_crossing(outline, head.place)) {
      head.ending = Head::crossing;
      return bytes_of(head, out);
    }
    fill(outline, outline.facets, points, in);
    std::string switches = "pYJq2.0/10Q";
    tetrahedralize(switches.data(), &in, &out);
    head.points = at(out.numberofpoints), head.numbers = 4 * at(out.numberoftetrahedra);
  } catch (int error) {
    constexpr int no_memory = 1;
    if (error != no_memory) throw;
    head.ending = Head::no_memory;
  }
  return bytes_of(head, out);
}

}  // namespace

Tetrahedra tetrahedra_in(const Outline& outline, std::span<const Vec<3>> points) {
  const Vec<3> first = outline.places.empty() ? Vec<3>{} : outline.places.front();
  const std::optional<std::string> bytes = from_a_child([&] { return make(outline, points); });
  Head head;
  if (!bytes || bytes->size() < sizeof head) refuse_mesh(first, "TetGen failed on the surfaces there");
  std::memcpy(&head, bytes->data(), sizeof head);
  if (head.ending == Head::crossing)
    refuse_mesh(head.place, "the surfaces of bodies or obstacles cross or touch there");
  if (head.ending == Head::no_memory) refuse_mesh(first, "it takes more memory than there is");
  Tetrahedra made;
  made.x.resize(head.points), made.nodes.resize(head.numbers);
  std::memcpy(made.x.data(), bytes->data() + sizeof head, head.points * sizeof(Vec<3>));
  std::memcpy(made.nodes.data(), bytes->data() + sizeof head + head.points * sizeof(Vec<3>),
              head.numbers * sizeof(int));
  return made;
}

#else

Tetrahedra tetrahedra_in(const Outline& /*outline*/, std::span<const Vec<3>> /*points*/) {
  throw RunError("this build makes no tetrahedra: TetGen was not there when it was made");
}

#endif

}  // namespace tether::coupled
