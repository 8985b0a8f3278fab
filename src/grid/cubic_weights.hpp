// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace tether {

/// Cubic B-spline weights, along one axis, of the two nodes before a place and the two behind it; r is the place's
/// logical coordinate in its cell, 0 to 1. The products of two axes are the 16-vertex kernel of (7.6).
inline std::array<double, 4> cubic_weights(double r) {
  const double q = 1 - r;
  return {q * q * q / 6, (4 - 3 * r * r * (1 + q)) / 6, (4 - 3 * q * q * (1 + r)) / 6, r * r * r / 6};
}

/// Their derivatives in r (7.7).
inline std::array<double, 4> cubic_slopes(double r) {
  const double q = 1 - r;
  return {-0.5 * q * q, r * (1.5 * r - 2), q * (2 - 1.5 * q), 0.5 * r * r};
}

}  // namespace tether
