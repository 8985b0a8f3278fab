// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/mesh/mesh_map.hpp"

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"

namespace tether::coupled {
namespace {

/// The shares of a facet's nodes at that place.
Vec<3> shares_on(const SolidSurface& surface, std::size_t side, std::span<const double> q, const Vec<3>& x) {
  const auto nodes = surface.side(side);
  const Vec<3> a = place_of(q, nodes[0], surface.dim), from = minus(x, a),
               u = minus(place_of(q, nodes[1], surface.dim), a);
  Vec<3> share{};
  if (surface.dim == 2) {
    share[1] = dot(from, u) / dot(u, u);
  } else {
    const Vec<3> v = minus(place_of(q, nodes[2], 3), a), n = cross(u, v);
    share[1] = dot(cross(from, v), n) / dot(n, n), share[2] = dot(cross(u, from), n) / dot(n, n);
  }
  share[0] = 1 - share[1] - share[2];
  double sum = 0;
  for (double& of : share) of = std::max(of, 0.0), sum += of;
  return {share[0] / sum, share[1] / sum, share[2] / sum};
}

}  // namespace

/// By the facet's own nodes, though the element's functions may say otherwise within a side: the fluid has flat faces,
/// and what they sweep must be what the bodies' volume changes by. With the functions of quadrilaterals a body in a
/// closed room swelled in modes that the volume term does not see, and took the more of it.
NodeShares node_shares(const SolidSurface& surface, std::size_t facet, std::span<const double> q, const Vec<3>& x) {
  const Vec<3> shares = shares_on(surface, facet, q, x);
  const auto nodes = surface.side(facet);
  NodeShares of_nodes;
  for (std::size_t k = 0; k < nodes.size(); ++k) of_nodes.emplace_back(at(nodes[k]), shares[k]);
  return of_nodes;
}

std::vector<double> area_seen(const FlowMesh& mesh, const SolidSurface& surface) {
  const std::size_t count = at(mesh.regions);
  std::vector<double> seen(at(surface.sheets) * count, 0.0);
  for (std::size_t face = 0; face < mesh.faces(); ++face) {
    if (mesh.boundary[face].kind != BoundaryKind::solid) continue;
    const int sheet = surface.sheet[at(mesh.boundary[face].number)];
    seen[at(sheet) * count + at(mesh.region[mesh.cell_of(face)])] += mesh.size_of(face);
  }
  return seen;
}

SideEntries fluxes_on_mesh(const FlowMesh& mesh, const FacePressures& pressures, const SolidSurface& surface,
                           std::span<const double> q) {
  SideSums sums(at(mesh.dim));
  for (std::size_t face = 0; face < mesh.faces(); ++face) {
    if (mesh.boundary[face].kind != BoundaryKind::solid) continue;
    const int side = mesh.boundary[face].number;
    const Vec<3> area = area_of_side(surface, at(side), q);
    const double part = std::min(1.0, mesh.size_of(face) / std::sqrt(dot(area, area)));
    sums.begin(side);
    double* entries = sums.row(pressures.of[face]);
    const Vec<3> share = shares_on(surface, at(side), q, mesh.middle_of_face(face));
    for (std::size_t a = 0; a < at(mesh.dim); ++a) {
      for (std::size_t i = 0; i < at(mesh.dim); ++i) entries[3 * a + i] = -part * share[a];
    }
  }
  return sums.take();
}

/// By two places of each facet's part that is beyond, which integrate squares.
void add_beyond(const SolidSurface& surface, std::span<const double> q, int axis, double end, bool high,
                const std::function<double(double)>& p, SideSums& given) {
  const double sign = high ? 1 : -1, half = 0.5 / std::sqrt(3.0);
  for (std::size_t side = 0; side < surface.side_count(); ++side) {
    const auto nodes = surface.side(side);
    const Vec<3> a = place_of(q, nodes[0], 2), way = minus(place_of(q, nodes[1], 2), a);
    const double first = sign * (a[at(axis)] - end), last = first + sign * way[at(axis)];  // how far beyond
    if (first <= 0 && last <= 0) continue;
    const double from = first >= 0 ? 0 : first / (first - last), to = last >= 0 ? 1 : first / (first - last);
    given.begin(static_cast<int>(side));
    double* entries = given.row(CouplingMap::outside_row);
    for (const double at_part : {0.5 - half, 0.5 + half}) {
      const double t = from + at_part * (to - from), y = a[1] + t * way[1];
      for (const std::size_t node : {0U, 1U}) {
        const double share = node == 0 ? 1 - t : t;
        for (std::size_t i = 0; i < 2; ++i) entries[3 * node + i] -= 0.5 * (to - from) * share * p(y);
      }
    }
  }
}

}  // namespace tether::coupled
