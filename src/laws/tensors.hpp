// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tether {

struct Vec2 {
  double x = 0, y = 0;
};

/// In-plane components of the Cauchy stress [stress]; tension is positive.
struct Stress {
  double xx = 0, yy = 0, xy = 0;
};

/// Gradient of the velocity, first index the component: xy = d v_x / d y [rate].
struct VelocityGradient {
  double xx = 0, xy = 0, yx = 0, yy = 0;
};

/// In-plane components of a small strain, xy the tensor component.
struct Strain {
  double xx = 0, yy = 0, xy = 0;
};

/// Its rate, the symmetric part of the velocity gradient (4.2) [rate].
using StrainRate = Strain;

inline StrainRate symmetric_part(const VelocityGradient& L) { return {L.xx, L.yy, 0.5 * (L.xy + L.yx)}; }

/// sigma : eps' in the plane [stress rate].
inline double power(const Stress& s, const StrainRate& d) { return s.xx * d.xx + s.yy * d.yy + 2 * s.xy * d.xy; }

/// t . d . t, the rate at which a line along the unit vector t stretches (5.2).
inline double along(const StrainRate& d, const Vec2& t) {
  return d.xx * t.x * t.x + d.yy * t.y * t.y + 2 * d.xy * t.x * t.y;
}

}  // namespace tether
