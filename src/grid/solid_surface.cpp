// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/solid_surface.hpp"

#include <algorithm>
#include <numeric>

#include "grid/mesh.hpp"
#include "grid/shapes.hpp"

namespace tether {
namespace {

/// Sheets by nodes that sides share, numbered as they come.
void find_sheets(std::size_t nodes, SolidSurface& surface) {
  std::vector<int> above(nodes), number(nodes, -1);
  std::iota(above.begin(), above.end(), 0);
  const auto d = static_cast<std::size_t>(surface.dim);
  const std::size_t count = surface.sides.size() / d;
  for (std::size_t s = 0; s < count; ++s) {
    const int root = root_of(above, surface.sides[s * d]);
    for (std::size_t a = 1; a < d; ++a)
      above[static_cast<std::size_t>(root_of(above, surface.sides[s * d + a]))] = root;
  }
  surface.sheet.resize(count);
  for (std::size_t s = 0; s < count; ++s) {
    int& known = number[static_cast<std::size_t>(root_of(above, surface.sides[s * d]))];
    if (known < 0) known = surface.sheets++;
    surface.sheet[s] = known;
  }
}

}  // namespace

SolidSurface surface_of(const Mesh& mesh) {
  SolidSurface surface;
  surface.dim = mesh.dim();
  surface.kind = mesh.kind;
  surface.whole_sides = boundary_of(mesh);
  surface.parting = facets_of_side(mesh.kind);
  const auto per_side = static_cast<std::size_t>(side_node_count_of(mesh.kind));
  for (std::size_t first = 0; first < surface.whole_sides.size(); first += per_side) {
    for (const auto& facet : surface.parting) {
      for (int a = 0; a < surface.dim; ++a)
        surface.sides.push_back(
            surface.whole_sides[first + static_cast<std::size_t>(facet[static_cast<std::size_t>(a)])]);
    }
  }
  find_sheets(mesh.node_count(), surface);
  const std::vector<int> parts = parts_of(mesh);
  surface.parts = count_parts(mesh);
  for (std::size_t s = 0; s < surface.side_count(); ++s)
    surface.part.push_back(parts[static_cast<std::size_t>(surface.side(s)[0])]);
  for (const double volume : enclosed_volumes(surface, mesh.x)) surface.cavity.push_back(volume < 0 ? 1 : 0);
  return surface;
}

namespace {

/// The functions of a whole side at the place whose shares of a facet's nodes are these.
template <class Side>
CarrierShares carried_by(const std::array<int, 3>& facet, const Vec<3>& share) {
  Vec<Side::dim> s{};
  for (std::size_t a = 0; a <= std::size_t{Side::dim}; ++a) {
    const auto node = Side::node_place(facet[a]);
    for (std::size_t i = 0; i < s.size(); ++i) s[i] += share[a] * node[i];
  }
  const auto N = Side::values(s);
  CarrierShares shares{};
  std::copy(N.begin(), N.end(), shares.begin());
  return shares;
}

}  // namespace

CarrierShares SolidSurface::carried(std::size_t s, const Vec<3>& share) const {
  if (parting.size() == 1) return {share[0], share[1], share[2]};  // the side is its facet
  return with_shapes(kind, [&](auto shapes) {
    return carried_by<typename decltype(shapes)::Side>(parting[s % parting.size()], share);
  });
}

Vec<3> place_of(std::span<const double> q, int node, int dim) {
  const std::size_t first = static_cast<std::size_t>(node) * static_cast<std::size_t>(dim);
  return {q[first], q[first + 1], dim == 3 ? q[first + 2] : 0};
}

std::vector<double> middle_of(std::span<const double> q0, std::span<const double> q1) {
  std::vector<double> middle(q0.size());
  for (std::size_t k = 0; k < middle.size(); ++k) middle[k] = 0.5 * (q0[k] + q1[k]);
  return middle;
}

Vec<3> area_of_side(const SolidSurface& surface, std::size_t side, std::span<const double> q) {
  const auto nodes = surface.side(side);
  const Vec<3> a = place_of(q, nodes[0], surface.dim), b = place_of(q, nodes[1], surface.dim);
  const Vec<3> e{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
  if (surface.dim == 2) return {e[1], -e[0], 0};
  const Vec<3> c = place_of(q, nodes[2], surface.dim);
  const Vec<3> f{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
  return {0.5 * (e[1] * f[2] - e[2] * f[1]), 0.5 * (e[2] * f[0] - e[0] * f[2]), 0.5 * (e[0] * f[1] - e[1] * f[0])};
}

std::vector<Vec<3>> areas_of_sides(const SolidSurface& surface, std::span<const double> q) {
  std::vector<Vec<3>> area(surface.side_count());
  for (std::size_t s = 0; s < area.size(); ++s) area[s] = area_of_side(surface, s, q);
  return area;
}

/// In space 2 A = x0 x x1 + x1 x x2 + x2 x x0, so that dx_k changes it by dx_k x (x_(k+1) - x_(k+2)).
Vec<3> slope_of_area(const SolidSurface& surface, std::size_t side, std::span<const double> q, std::size_t k,
                     const Vec<3>& z) {
  if (surface.dim == 2) return k == 0 ? Vec<3>{z[1], -z[0], 0} : Vec<3>{-z[1], z[0], 0};
  const auto nodes = surface.side(side);
  const Vec<3> a = place_of(q, nodes[(k + 1) % 3], 3), b = place_of(q, nodes[(k + 2) % 3], 3);
  const Vec<3> twice = cross(minus(a, b), z);
  return {0.5 * twice[0], 0.5 * twice[1], 0.5 * twice[2]};
}

/// Uses the divergence theorem: 1/dim of the sum of x . n, x at the side's middle, about the surface's first node, so
/// that a place far from the origin costs no digits.
std::vector<double> enclosed_volumes(const SolidSurface& surface, std::span<const double> q) {
  std::vector<double> volumes(static_cast<std::size_t>(surface.sheets), 0.0);
  std::vector<int> origin(volumes.size(), -1);
  for (std::size_t s = 0; s < surface.side_count(); ++s) {
    const auto sheet = static_cast<std::size_t>(surface.sheet[s]);
    if (origin[sheet] < 0) origin[sheet] = surface.side(s)[0];
    const Vec<3> from = place_of(q, origin[sheet], surface.dim), area = area_of_side(surface, s, q);
    for (const int node : surface.side(s)) {
      const Vec<3> x = place_of(q, node, surface.dim);
      for (std::size_t i = 0; i < 3; ++i) volumes[sheet] += (x[i] - from[i]) * area[i] / (surface.dim * surface.dim);
    }
  }
  return volumes;
}

std::vector<double> swept_volumes(const SolidSurface& surface, std::span<const double> middle,
                                  std::span<const double> q0, std::span<const double> q1) {
  std::vector<double> volumes(static_cast<std::size_t>(surface.sheets), 0.0);
  for (std::size_t s = 0; s < surface.side_count(); ++s) {
    const Vec<3> area = area_of_side(surface, s, middle);
    for (const int node : surface.side(s)) {
      const Vec<3> from = place_of(q0, node, surface.dim), to = place_of(q1, node, surface.dim);
      for (std::size_t i = 0; i < 3; ++i)
        volumes[static_cast<std::size_t>(surface.sheet[s])] += (to[i] - from[i]) * area[i] / surface.dim;
    }
  }
  return volumes;
}

}  // namespace tether
