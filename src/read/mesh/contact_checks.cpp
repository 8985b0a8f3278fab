// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/mesh/contact_checks.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <string>

#include "base/numbers.hpp"
#include "grid/contact/apart.hpp"
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
  const std::string where =
      surface.dim() == 3 ? fmt::format("({:.6g}, {:.6g}, {:.6g})", apart.place[0], apart.place[1], apart.place[2])
                         : fmt::format("({:.6g}, {:.6g})", apart.place[0], apart.place[1]);
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

}  // namespace

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

}  // namespace tether
