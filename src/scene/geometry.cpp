// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/geometry.hpp"

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

bool Ellipse::contains(double px, double py) const {
  if (!(a > 0) || !(b > 0)) return false;
  const double u = (px - xc) / a, v = (py - yc) / b;
  return u * u + v * v < 1;
}

}  // namespace tether
