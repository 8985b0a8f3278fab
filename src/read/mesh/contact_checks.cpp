// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/mesh/contact_checks.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/numbers.hpp"
#include "grid/contact/apart.hpp"
#include "grid/mesh_flaws.hpp"
#include "grid/overlaps.hpp"
#include "read/values.hpp"

namespace tether {
namespace {

constexpr double part_of_side = 0.1;    // that the gap is of the shortest side
constexpr double touching = 1e-3;       // of that gap: surfaces that are no farther apart count as touching
constexpr double pressed_a_lot = 0.95;  // of a gap of the deck: nearer surfaces press each other at the start

/// "region 1 and region 2 at (0.5, 1)".
std::string meeting_text(const ContactSurface& surface, const Solids& solids, const Apart& apart) {
  const auto region = [&](int side) { return solids.regions[at(surface.side_region[at(side)])].name; };
  const int first = apart.side < 0 ? apart.other : apart.side, second = apart.side < 0 ? -1 : apart.other;
  const std::string where = place_text(apart.place, surface.dim());
  return fmt::format("{} and {} at {}", region(first), second < 0 ? "a wall, plane or obstacle" : region(second),
                     where);
}

/// How far bodies are from themselves at the start, of what is nearer than `usual`. An equilibrium takes no smaller gap
/// than that: it stores nothing that it would not, and needs the barrier to hold bodies at once; but what is near by
/// its shape alone is not to be pressed for that.
double apart_by_shape(const Solids& solids, const Contact& contact, double usual) {
  Team team;
  const ContactSurface bodies = contact_surface(solids.mesh, contact.nodes, {});
  return nearest_surfaces(bodies, {.bodies = false, .itself = contact.itself}, {}, solids.mesh.x, usual, team).away;
}

/// Warns of the first region whose law fails where it is squeezed.
void warn_of_laws(const Deck& deck, const Solids& solids, Diagnostics& diagnostics) {
  for (std::size_t r = 0; r < solids.regions.size(); ++r) {
    if (!std::holds_alternative<StVenantKirchhoff>(solids.regions[r].law)) continue;
    const int number = static_cast<int>(r) + 1;
    diagnostics.add(deck.remark(
        Severity::warning, "fem.law", {number, 1},
        fmt::format("region {}: St Venant-Kirchhoff's law softens where it is squeezed, and lets elements turn inside "
                    "out: bodies that meet hard come to grief",
                    number),
        fmt::format("law({})='neo-hookean' resists; small strains agree", number)));
    return;
  }
}

/// Places on a box's edges that are no farther apart than `spacing`.
std::vector<Vec<3>> places_on_edges(const Box<3>& box, int dim, double spacing) {
  constexpr double most = 400;  // parts of an edge
  std::vector<Vec<3>> places;
  for (int corner = 0; corner < 1 << dim; ++corner) {
    for (int axis = 0; axis < dim; ++axis) {
      if ((corner >> axis & 1) != 0) continue;  // the edge belongs to its lower corner
      const double length = box.high[at(axis)] - box.low[at(axis)], parts = std::min(most, std::ceil(length / spacing));
      for (int k = 0; k <= parts; ++k) {
        Vec<3> place{};
        for (int i = 0; i < dim; ++i) place[at(i)] = (corner >> i & 1) != 0 ? box.high[at(i)] : box.low[at(i)];
        place[at(axis)] += length * k / parts;
        places.push_back(place);
      }
    }
  }
  return places;
}

/// Reports the first obstacle of $contact, or of $coupled, of which an edge reaches into a body at the start.
void check_obstacles(const Deck& deck, const Solids& solids, const Contact& contact, Diagnostics& diagnostics) {
  const int dim = solids.mesh.dim();
  const double spacing = 0.5 * contact_surface(solids.mesh, contact.nodes, {}).shortest;
  OverlapFinder finder(solids.mesh);
  for (const Box<3>& box : contact.obstacles) {
    const auto held = finder.find_held(places_on_edges(box, dim, spacing), solids.mesh.x);
    if (!held) continue;
    diagnostics.add(
        deck.remark_on_group(Severity::error, "contact",
                             fmt::format("an obstacle reaches into a body at the start, at {}", place_text(*held, dim)),
                             "bodies start out of obstacles"));
    return;
  }
}

/// Sets the gap of a contact that the deck gives none: a tenth of the shortest side of the surface, or what surfaces
/// that meet are apart at the start where that is less and the bodies move (of an equilibrium: only where a body is so
/// near to itself by its shape). Reports surfaces that touch at the start, between which no barrier can stand, and a
/// gap of the deck that presses bodies at the start.
void find_gap(const Deck& deck, const Solids& solids, Contact& contact, Diagnostics& diagnostics) {
  Team team;
  const ContactSurface surface = contact_surface(solids.mesh, contact.nodes, contact.obstacles);
  const double usual = part_of_side * surface.shortest;
  const bool given = contact.gap > 0;
  if (!given) contact.gap = usual;
  const Apart apart = nearest_surfaces(surface, {contact.bodies, contact.itself}, contact.planes, solids.mesh.x,
                                       std::max(usual, contact.gap), team);
  if (apart.away >= contact.gap) return;
  if (apart.away <= touching * usual) {
    diagnostics.add(deck.remark_on_group(
        Severity::error, "contact",
        fmt::format("{} touch at the start: no barrier can stand between them", meeting_text(surface, solids, apart)),
        fmt::format(
            "leave {:.3g} between surfaces, a hundredth of the shortest side, or more; a gap of {:.3g} is usual",
            usual / 10, usual)));
  } else if (!given) {
    const bool rests = solids.integrator == Integrator::equilibrium || solids.from_equilibrium;
    contact.gap = rests ? std::min(usual, apart_by_shape(solids, contact, usual)) : apart.away;
  } else if (apart.away < pressed_a_lot * contact.gap) {
    diagnostics.add(deck.remark(Severity::warning, "contact.gap", {1, 1},
                                fmt::format("{} are {:.3g} apart, less than the gap: they press each other from the "
                                            "start, which stores energy",
                                            meeting_text(surface, solids, apart), apart.away),
                                "leave gap away, and it is what bodies are apart where that is little"));
  }
}

}  // namespace

void check_contact(const Deck& deck, const Solids& solids, Contact& contact, Diagnostics& diagnostics) {
  warn_of_laws(deck, solids, diagnostics);
  if (!diagnostics.has_errors()) check_obstacles(deck, solids, contact, diagnostics);
  if (!diagnostics.has_errors()) find_gap(deck, solids, contact, diagnostics);
}

}  // namespace tether
