// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>

namespace tether {

/// What a plane scene stands for: a slab one unit deep, or a body of revolution, x the radius and y the axis.
enum class Geometry { plane, axisymmetric };

/// Depth of the scene at x: 1, or the way round 2 pi r; volumes, masses and energies are whole ones [length].
inline double depth(Geometry geometry, double x) {
  return geometry == Geometry::plane ? 1.0 : 2 * std::numbers::pi * x;
}

}  // namespace tether
