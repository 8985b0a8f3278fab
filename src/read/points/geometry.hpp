// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"
#include "grid/boxes.hpp"

namespace tether {

/// Returns what cyl says: a plane scene, or one about the axis x = 0.
Geometry geometry_of(const Deck& deck);

/// Reports where the grid or its left wall cannot be what a scene about an axis needs.
void check_axis(const Deck& deck, Diagnostics& diagnostics);

/// Two sides of a polygon, each from its vertex of this number, from 0, to the next.
struct CrossingSides {
  std::size_t first, second;
};

/// A closed polygon of at least 3 vertices, convex or not.
struct Polygon {
  std::vector<double> x, y;  // [length]

  /// Even-odd rule. Of two polygons that share an edge, a place on the edge lies in exactly one.
  bool contains(double px, double py) const;
  /// The first sides that pass through one another, not those that only touch; nothing where none do.
  std::optional<CrossingSides> crossing() const;
};

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
