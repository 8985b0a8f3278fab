// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"
#include "grid/boxes.hpp"
#include "grid/polygon.hpp"

namespace tether {

/// Returns what cyl says: a plane scene, or one about the axis x = 0.
Geometry geometry_of(const Deck& deck);

/// Reports where the grid or its left wall cannot be what a scene about an axis needs.
void check_axis(const Deck& deck, Diagnostics& diagnostics);

/// (x - xc)^2 / a^2 + (y - yc)^2 / b^2 < 1; a half axis of 0 makes an ellipse that holds nothing.
struct Ellipse {
  double xc = 0, yc = 0, a = 0, b = 0;  // [length]

  bool contains(double px, double py) const;
};

/// The thesis' region: inside the polygon AND inside the outer ellipse AND outside the inner one.
struct RegionShape {
  Polygon polygon;
  Ellipse outer, inner;

  bool contains(double px, double py) const {
    return polygon.contains(px, py) && outer.contains(px, py) && !inner.contains(px, py);
  }
};

}  // namespace tether
