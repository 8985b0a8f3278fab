// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/vec.hpp"

namespace tether {

/// In-plane components of the Cauchy stress, and the one across the plane, which about an axis is the hoop's [stress];
/// tension is positive.
struct Stress {
  double xx = 0, yy = 0, xy = 0, zz = 0;
};

/// Gradient of the velocity, first index the component: xy = d v_x / d y [rate].
struct VelocityGradient {
  double xx = 0, xy = 0, yx = 0, yy = 0;
};

/// Components of a small strain, xy the tensor component; zz is 0 in the plane and the hoop's about an axis.
struct Strain {
  double xx = 0, yy = 0, xy = 0, zz = 0;
};

/// Its rate, the symmetric part of the velocity gradient (4.2) [rate].
using StrainRate = Strain;

inline StrainRate symmetric_part(const VelocityGradient& L) { return {L.xx, L.yy, 0.5 * (L.xy + L.yx)}; }

/// sigma : eps' [stress rate].
inline double power(const Stress& s, const StrainRate& d) {
  return s.xx * d.xx + s.yy * d.yy + 2 * s.xy * d.xy + s.zz * d.zz;
}

/// The stress after its material has turned by the small angle `spin` dt from y towards x (Jaumann's rate).
inline Stress turned(const Stress& s, double angle) {
  return {s.xx + 2 * angle * s.xy, s.yy - 2 * angle * s.xy, s.xy + angle * (s.yy - s.xx), s.zz};
}

/// t . d . t, the rate at which a line along the unit vector t stretches (5.2).
inline double along(const StrainRate& d, const Vec<2>& t) {
  return d.xx * t[0] * t[0] + d.yy * t[1] * t[1] + 2 * d.xy * t[0] * t[1];
}

}  // namespace tether
