// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>
#include <vector>

#include "base/numbers.hpp"
#include "base/vec.hpp"
#include "grid/solid_surface.hpp"
#include "read/box/box.hpp"
#include "read/mesh/contact.hpp"
#include "read/mesh/contact_checks.hpp"

namespace tether {
namespace {

/// Sides of the box that stop bodies, whatever fluid passes.
std::set<int> walls_of(const Coupled& coupled) {
  std::set<int> walls;
  for (int side = 0; coupled.contact && side < 2 * coupled.grid.dim; ++side) {
    if (is_wall(coupled.sides[at(side)])) walls.insert(side);
  }
  return walls;
}

SurfacePlane plane_of(const StaggeredGrid& grid, int side) {
  const auto axis = at(axis_of_side(side));
  SurfacePlane plane;
  plane.place = grid.low;
  if (!is_low_side(side)) plane.place[axis] = grid.high(axis_of_side(side));
  plane.normal[axis] = is_low_side(side) ? 1 : -1;
  return plane;
}

/// Returns whether a place is at a wall or an obstacle, or beyond.
bool is_at_a_wall(const Contact& contact, const Vec<3>& x, int dim, double near) {
  const auto at_box = [&](const Box<3>& box) {
    bool inside = true;
    for (std::size_t i = 0; i < at(dim); ++i) inside &= x[i] >= box.low[i] - near && x[i] <= box.high[i] + near;
    return inside;
  };
  return std::ranges::any_of(
             contact.planes,
             [&](const SurfacePlane& plane) { return dot(plane.normal, minus(x, plane.place)) <= near; }) ||
         std::ranges::any_of(contact.obstacles, at_box);
}

/// Takes the sides of bodies that are rooted in a wall, where they are, out of those that meet something: all of their
/// places start there.
void leave_roots(const Solids& solids, double near, Contact& contact) {
  const int dim = solids.mesh.dim();
  std::set<int> roots;
  for (const Support& support : solids.supports) {
    for (const int node : support.nodes) {
      if (is_at_a_wall(contact, place_of(solids.mesh.x, node, dim), dim, near)) roots.insert(node);
    }
  }
  if (roots.empty()) return;
  if (contact.nodes.empty()) {
    for (int node = 0; node < static_cast<int>(solids.mesh.node_count()); ++node) contact.nodes.push_back(node);
  }
  std::erase_if(contact.nodes, [&](int node) { return roots.contains(node); });
}

}  // namespace

std::optional<Contact> contact_in_box(const Deck& deck, const Scene& scene, const Coupled& coupled,
                                      const Solids& solids, Diagnostics& diagnostics) {
  constexpr double rounding = 1e-9;  // of a cell
  if (!coupled.contact && !deck.has_group("contact")) return std::nullopt;
  const std::set<int> walls = walls_of(coupled);
  Contact contact = read_contact(deck, scene, solids, walls, diagnostics);
  if (!deck.given("contact.friction")) contact.friction = coupled.friction;
  for (const int side : walls) contact.planes.push_back(plane_of(coupled.grid, side));
  if (coupled.contact)
    contact.obstacles.insert(contact.obstacles.end(), coupled.obstacles.begin(), coupled.obstacles.end());
  leave_roots(solids, rounding * coupled.grid.d[0], contact);
  check_contact(deck, solids, contact, diagnostics);
  return contact;
}

}  // namespace tether
