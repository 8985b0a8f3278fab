// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <span>

#include "grid/pair.hpp"

namespace tether::mpm {

/// Where the points of a scene stand [length].
struct PlaceArrays {
  std::span<const double> x, y;
};

/// Unit tangents by point: those of before when a rule is asked, its own when it returns.
struct Tangents {
  std::span<double> x, y;
};

/// Turns the tangent of point p across the gradient of a colour, to the side of the tangent before. A gradient that is
/// not longer than `least` tells no direction: the tangent stays.
inline void turn_across(const Tangents& tangents, std::size_t p, Pair gradient, double least) {
  const double length = std::sqrt(gradient[0] * gradient[0] + gradient[1] * gradient[1]);
  if (!(length > least)) return;
  double& tx = tangents.x[p];
  double& ty = tangents.y[p];
  const double sign = ty * gradient[0] < tx * gradient[1] ? 1 : -1;
  tx = sign * gradient[1] / length, ty = -sign * gradient[0] / length;
}

}  // namespace tether::mpm
