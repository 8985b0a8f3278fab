// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace tether {

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

}  // namespace tether
