// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/mesh/contact_checks.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "base/numbers.hpp"
#include "grid/contact/apart.hpp"
#include "grid/winding.hpp"
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

namespace {

/// A place of a box's edges that lies in a body, of places no farther apart than `spacing`; a box that touches a body
/// has none.
std::optional<Vec<3>> place_in_bodies(const SolidSurface& surface, std::span<const double> x, Box<3> box,
                                      double spacing) {
  constexpr int most = 400;  // places of an edge
  constexpr double within = 1e-6;
  for (std::size_t i = 0; i < at(surface.dim); ++i) box.low[i] += within * spacing, box.high[i] -= within * spacing;
  for (int corner = 0; corner < 1 << surface.dim; ++corner) {
    for (int axis = 0; axis < surface.dim; ++axis) {
      if ((corner >> axis & 1) != 0) continue;  // the edge belongs to its lower corner
      const double length = box.high[at(axis)] - box.low[at(axis)];
      const int parts = static_cast<int>(std::clamp(std::ceil(length / spacing), 1.0, double{most}));
      for (int k = 0; k <= parts; ++k) {
        Vec<3> place{};
        for (int i = 0; i < surface.dim; ++i) place[at(i)] = (corner >> i & 1) != 0 ? box.high[at(i)] : box.low[at(i)];
        place[at(axis)] += length * k / parts;
        if (winding(surface, x, place) > 0.5) return place;
      }
    }
  }
  return std::nullopt;
}

}  // namespace

void check_obstacles(const Deck& deck, const Solids& solids, const Contact& contact, Diagnostics& diagnostics) {
  const SolidSurface surface = surface_of(solids.mesh);
  const double spacing = 0.5 * contact_surface(solids.mesh, contact.nodes, {}).shortest;
  for (const Box<3>& box : contact.obstacles) {
    const auto place = place_in_bodies(surface, solids.mesh.x, box, spacing);
    if (!place) continue;
    diagnostics.add(deck.remark_on_group(
        Severity::error, "contact",
        fmt::format("an obstacle reaches into a body at the start, at ({:.6g}, {:.6g}{})", (*place)[0], (*place)[1],
                    surface.dim == 3 ? fmt::format(", {:.6g}", (*place)[2]) : ""),
        "bodies start out of obstacles"));
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
