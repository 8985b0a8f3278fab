// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <vector>

namespace tether {

/// A mass on a uniform elastic spring that hangs from a fixed wall, let go at rest with the spring unstretched.
/// Any consistent units; mass, stiffness > 0, spring_mass >= 0, t >= 0. Source: thesis 5.5, (5.10) and (5.11), for a
/// spring without mass, with y measured from the start instead of the static place: m y'' = -m g - k y,
/// y(0) = y'(0) = 0. Of a spring of mass M_s, length L and wave speed c = L sqrt(k/M_s) the stretch u(x, t) obeys
///   u_tt = c^2 u_xx + g,  u(0, t) = 0,  m u_tt = m g - k L u_x at x = L,
/// whose modes sin(z_n x/L) have the frequencies z_n sqrt(k/M_s), z_n tan(z_n) = M_s/m (derived here).
struct SpringMass {
  double mass = 0;
  double stiffness = 0;    ///< force/length
  double gravity = 0;      ///< acceleration, positive downwards (a deck's gravc has the other sign)
  double spring_mass = 0;  ///< of the spring itself, spread evenly along it

  double frequency() const;       ///< the lowest one, radians/time; sqrt(k/m) without spring_mass
  double period() const;          ///< 2 pi over that
  double static_stretch() const;  ///< (m + M_s/2) g/k, length
  /// The lowest place up to a time, length, positive downwards: 2 m g/k after half a period without spring_mass. The
  /// modes have no common period: in all time the mass comes as near as may be to where all that pull down do so.
  double largest_drop(double until = std::numeric_limits<double>::infinity()) const;
  /// y - y(0), length, positive upwards: -sum of A_n (1 - cos(omega_n t)).
  double position(double t) const;
  std::vector<double> positions(const std::vector<double>& times) const;

 private:
  struct Mode {
    double frequency = 0;  // radians/time
    double stretch = 0;    // A_n, the part of the static stretch [length]
  };
  std::vector<Mode> modes() const;
};

}  // namespace tether
