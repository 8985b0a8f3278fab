// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/points/geometry.hpp"

#include <fmt/format.h>

#include "laws/walls.hpp"

namespace tether {

Geometry geometry_of(const Deck& deck) { return deck.real("in.cyl") == 0 ? Geometry::plane : Geometry::axisymmetric; }

void check_axis(const Deck& deck, Diagnostics& diagnostics) {
  if (geometry_of(deck) == Geometry::plane) return;
  const double left = deck.real("in.xleft");
  if (left < 0) {
    diagnostics.add(deck.remark(Severity::error, "in.xleft", {1, 1},
                                fmt::format("xleft = {:.6g} lies beyond the axis", left),
                                "with cyl=1 x is the radius: xleft >= 0"));
  }
  const int wall = deck.integer("in.wl");
  if (left == 0 && !mirrors(static_cast<Wall>(wall))) {
    diagnostics.add(deck.remark(Severity::error, "in.wl", {1, 1}, fmt::format("wl = {} stands on the axis", wall),
                                "nothing crosses the axis, and what lies on it may slide along: write wl=5"));
  }
}

bool Ellipse::contains(double px, double py) const {
  if (!(a > 0) || !(b > 0)) return false;
  const double u = (px - xc) / a, v = (py - yc) / b;
  return u * u + v * v < 1;
}

}  // namespace tether
