// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/mesh/outline.hpp"

#include <cmath>

namespace tether::coupled {

double Outline::size_of(const Facet& facet) const {
  const Vec<3>& a = places[facet.corners[0]];
  const Vec<3> along = minus(places[facet.corners[1]], a);
  if (dim == 2) return std::sqrt(dot(along, along));
  const Vec<3> twice = cross(along, minus(places[facet.corners[2]], a));
  return std::sqrt(2 / std::sqrt(3.0) * std::sqrt(dot(twice, twice)));
}

}  // namespace tether::coupled
