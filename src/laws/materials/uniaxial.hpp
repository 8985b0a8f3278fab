// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "laws/tensors.hpp"

namespace tether {

/// A string or spring: stress along its tangent only (5.5)-(5.9). With `wrinkle` the one-way law (5.2, Fig. 21): no
/// stress under a compressive strain, which goes on accumulating.
struct Uniaxial {
  double E = 0, nu = 0;  // [stress], number
  bool wrinkle = true;

  double stress(double strain) const { return wrinkle && strain < 0 ? 0 : E * strain; }  // (5.5)
  double energy_density(double strain) const { return 0.5 * stress(strain) * strain; }
  double sound_speed(double density) const { return std::sqrt(E / density); }

  /// sigma_1' t (x) t in global axes.
  static Stress turned(double tangent_stress, const Vec2& t) {
    return {tangent_stress * t.x * t.x, tangent_stress * t.y * t.y, tangent_stress * t.x * t.y};
  }
};

}  // namespace tether
