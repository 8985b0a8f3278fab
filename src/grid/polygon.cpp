// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/polygon.hpp"

namespace tether {

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

}  // namespace tether
