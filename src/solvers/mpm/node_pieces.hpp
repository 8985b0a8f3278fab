// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "grid/pair.hpp"
#include "laws/walls/walls.hpp"

namespace tether::mpm {

/// Walls: the held components are zero in the momentum AND in the force; a wall that changes only the momentum lets
/// the points take up the force (3.22) and blows up.
inline void hold(std::uint8_t held, Pair& v) {
  if (held & holds_x) v[0] = 0;
  if (held & holds_y) v[1] = 0;
}

/// Of a node's mass. With linear functions an active node has some (Locator::edge); a spline ends smoothly, so that a
/// node may have none, and then nothing reads it.
inline double inverse(double m) { return m > 0 ? 1 / m : 0; }

inline double dot(Pair a, Pair b) {
  a *= b;
  return a[0] + a[1];
}

inline double squared(Pair v) { return dot(v, v); }

}  // namespace tether::mpm
