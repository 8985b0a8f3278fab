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

bool Polygon::contains(double px, double py) const {
  bool inside = false;
  for (std::size_t k = 0, before = x.size() - 1; k < x.size(); before = k++) {
    if ((y[k] > py) == (y[before] > py)) continue;  // the edge does not cross the line to the right
    // From the lower vertex, so that two polygons round a shared edge alike, whichever way round they run.
    const std::size_t low = y[k] < y[before] ? k : before, high = low == k ? before : k;
    const double crossing = x[low] + (py - y[low]) * (x[high] - x[low]) / (y[high] - y[low]);
    if (px < crossing) inside = !inside;
  }
  return inside;
}

std::optional<CrossingSides> Polygon::crossing() const {
  const std::size_t n = x.size();
  // Twice the signed area of three vertices: on which side of the line from a to b the vertex c is.
  const auto side = [this](std::size_t a, std::size_t b, std::size_t c) {
    const double area = (x[b] - x[a]) * (y[c] - y[a]) - (y[b] - y[a]) * (x[c] - x[a]);
    return (area > 0) - (area < 0);
  };
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t c = a + 1; c < n; ++c) {
      const std::size_t b = (a + 1) % n, d = (c + 1) % n;
      if (side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0) return CrossingSides{a, c};
    }
  }
  return std::nullopt;
}

bool Ellipse::contains(double px, double py) const {
  if (!(a > 0) || !(b > 0)) return false;
  const double u = (px - xc) / a, v = (py - yc) / b;
  return u * u + v * v < 1;
}

}  // namespace tether
