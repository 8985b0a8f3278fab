// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tether {

/// A point mass on a rigid string, let go at rest at an angle from the vertical; the swing may be wide. A uniform
/// string of mu times the point's mass swings as a massless one of the length L (1 + mu/3)/(1 + mu/2), the moment of
/// inertia over the static moment. Any consistent units, angles in radians; length, gravity > 0. Angles of pi and
/// beyond throw std::domain_error: a string that begins upright or beyond does not swing. Source: L. D. Landau and E.
/// M. Lifshitz, Mechanics, section 11, problem 1; the problem is that of thesis 5.7 (Table 1), whose string stretches a
/// little.
struct Pendulum {
  double length = 0;
  double gravity = 0;      ///< acceleration, positive downwards (a deck's gravc has the other sign)
  double start_angle = 0;  ///< theta0 at t = 0, from the vertical
  double string_part = 0;  ///< mu, the string's mass over the point's
  double stretch = 0;      ///< m g/(E A), the strain of the string with the mass at rest

  double period() const;         ///< T = 4 sqrt(l/g) K(sin(theta0/2))
  double angle(double t) const;  ///< theta, from sin(theta/2) = sin(theta0/2) sn(K + sqrt(g/l) t)

 private:
  double swing_length() const;  ///< L (1 + m g/(E A)) (1 + mu/3)/(1 + mu/2)
  double modulus() const;       ///< k = sin(theta0/2); the checks of start_angle are here
};

}  // namespace tether
