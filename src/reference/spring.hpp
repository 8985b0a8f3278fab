// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tether {

/// A mass on a massless spring that hangs from a fixed wall, let go at rest with the spring unstretched.
/// Any consistent units; mass, stiffness > 0, t >= 0. Source: thesis 5.5, (5.10) and (5.11), with y measured from the
/// start instead of the static place: m y'' = -m g - k y, y(0) = y'(0) = 0.
struct SpringMass {
  double mass = 0;
  double stiffness = 0;  ///< force/length
  double gravity = 0;    ///< acceleration, positive downwards (a deck's gravc has the other sign)

  double frequency() const;         ///< sqrt(k/m), radians/time
  double period() const;            ///< 2 pi sqrt(m/k)
  double static_stretch() const;    ///< m g/k, length
  double largest_drop() const;      ///< 2 m g/k, length, positive downwards; reached after half a period
  double position(double t) const;  ///< y - y(0), length, positive upwards: -(m g/k) (1 - cos(omega t))
};

}  // namespace tether
