// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/contact/apart.hpp"

#include <cmath>

#include "base/numbers.hpp"
#include "grid/solid_surface.hpp"

namespace tether {

Apart nearest_surfaces(const ContactSurface& surface, WhoMeets who, std::span<const SurfacePlane> planes,
                       std::span<const double> q, double least, Team& team) {
  std::vector<double> x;
  surface.places.find(q, x);
  ContactPairs near(surface, who, team);
  near.find({std::span<const double>(x)}, least, 0);
  Apart apart{.away = INFINITY};
  for (const ContactPair& pair : near.pairs()) {
    const double away = std::sqrt(squared_distance(pair, surface.dim(), x));
    if (away < std::min(apart.away, least))
      apart = {away, pair.side, pair.other, place_of(x, pair.places[0], surface.dim())};
  }
  for (const SurfacePlane& plane : planes) {
    for (const ContactPoint& guard : surface.guards) {
      const Vec<3> place = place_of(x, guard.place, surface.dim());
      const double away = dot(plane.normal, minus(place, plane.place));
      if (guard.side >= 0 && away < std::min(apart.away, least)) apart = {away, guard.side, -1, place};
    }
  }
  return apart;
}

}  // namespace tether
