// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/liquid/facets.hpp"

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"

namespace tether::liquid {
namespace {

double volume_of(const std::array<Vec<3>, 4>& x, int dim) {
  const Vec<3> a = minus(x[1], x[0]), b = minus(x[2], x[0]);
  return dim == 2 ? std::abs(cross(a, b)[2]) / 2 : std::abs(dot(cross(a, b), minus(x[3], x[0]))) / 6;
}

/// Turns a facet so that a place in the liquid lies on the right side of it.
Facet turned(Facet facet, const Vec<3>& wet, int dim) {
  const Vec<3> e = minus(facet[1], facet[0]), to = minus(wet, facet[0]);
  const double side = dim == 2 ? cross(e, to)[2] : -dot(cross(e, minus(facet[2], facet[0])), to);
  if (side < 0) std::swap(facet[0], facet[1]);
  return facet;
}

}  // namespace

double area_of(const Facet& facet, int dim) {
  const Vec<3> e = minus(facet[1], facet[0]);
  if (dim == 2) return std::sqrt(dot(e, e));
  const Vec<3> n = cross(e, minus(facet[2], facet[0]));
  return std::sqrt(dot(n, n)) / 2;
}

Cut cut_of(const Simplex& simplex, int dim) {
  std::array<std::size_t, 4> order{0, 1, 2, 3};  // wet corners first
  const auto end = order.begin() + dim + 1;
  const auto dry = std::stable_partition(order.begin(), end, [&](std::size_t k) { return simplex.distance[k] < 0; });
  const auto wet = static_cast<int>(dry - order.begin());
  Cut cut;
  const double whole = volume_of(simplex.corner, dim);
  if (wet == 0 || wet == dim + 1) {
    cut.volume = wet == 0 ? 0 : whole;
    return cut;
  }
  const auto corner = [&](int k) -> const Vec<3>& { return simplex.corner[order[at(k)]]; };
  const auto between = [&](int a, int b) {  // where the surface meets the edge from a wet corner to a dry one
    const double in = simplex.distance[order[at(a)]], out = simplex.distance[order[at(b)]], t = in / (in - out);
    Vec<3> x{};
    for (std::size_t i = 0; i < 3; ++i) x[i] = (1 - t) * corner(a)[i] + t * corner(b)[i];
    return x;
  };
  if (wet == 1 || wet == dim) {  // one corner is alone
    const int alone = wet == 1 ? 0 : dim;
    Facet facet{};
    std::array<Vec<3>, 4> tip{corner(alone)};
    for (int k = 0, other = 0; k < dim; ++k, ++other) {
      if (other == alone) ++other;
      facet[at(k)] = wet == 1 ? between(0, other) : between(other, dim);
      tip[at(k) + 1] = facet[at(k)];
    }
    const double part = volume_of(tip, dim);
    cut.volume = wet == 1 ? part : whole - part;
    cut.facet[0] = turned(facet, corner(0), dim), cut.facets = 1;
    return cut;
  }
  const Vec<3> ac = between(0, 2), ad = between(0, 3), bc = between(1, 2), bd = between(1, 3);
  cut.volume = volume_of({corner(0), ac, ad, bd}, 3) + volume_of({corner(0), ac, bc, bd}, 3) +
               volume_of({corner(0), corner(1), bc, bd}, 3);
  cut.facet = {turned({ac, ad, bd}, corner(0), 3), turned({ac, bd, bc}, corner(0), 3)};
  cut.facets = 2;
  return cut;
}

std::vector<Facet> facets_of(const Surface& surface) {
  constexpr double least_open = 0.25;
  std::vector<Facet> facets;
  const auto skip = [](double, double) {};
  SurfaceLattice(surface).each(skip, [&](const Simplex& simplex) {
    if (simplex.open < least_open) return;
    const Cut cut = cut_of(simplex, surface.room.grid.dim);
    facets.insert(facets.end(), cut.facet.begin(), cut.facet.begin() + static_cast<std::ptrdiff_t>(cut.facets));
  });
  return facets;
}

}  // namespace tether::liquid
