// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <vector>

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

/// A piston on a massless spring that closes a rigid container of compressible fluid: vibration in one dimension.
/// Any consistent units; all numbers > 0, but mass and spring_stiffness may be 0.
/// Source: thesis 6.1, (6.1) and (6.2), after L. G. Olson and K.-J. Bathe, Nucl. Eng. Des. 76 (1983) 137-151.
struct Piston {
  double mass = 0;
  double spring_stiffness = 0;  ///< K, force/length
  double area = 0;              ///< A
  double fluid_length = 0;      ///< L, from the closed end to the piston
  double fluid_density = 0;     ///< rho
  double bulk_modulus = 0;      ///< beta, stress

  double sound_speed() const;  ///< c = sqrt(beta/rho)
  /// The lowest omega (radians/time) of m omega^2 = K + rho omega c A cot(omega L/c), (6.2): between 0 and pi c/L.
  double frequency() const;
  double period() const;  ///< 2 pi/omega
};

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

/// A mass below a massless string that pulls but does not push, let go at rest with the string slack.
/// The mass falls freely until the string is taut, swings about the static place as on a spring until the string goes
/// slack, and flies up to where it began; then all repeats. Any consistent units; mass, stiffness, gravity > 0,
/// slack >= 0, t >= 0. Source: thesis 5.6 (Fig. 29 names the phases; the closed form is elementary mechanics).
struct StringBounce {
  double mass = 0;
  double stiffness = 0;  ///< force/length of the taut string
  double gravity = 0;    ///< acceleration, positive downwards (a deck's gravc has the other sign)
  double slack = 0;      ///< length of the free fall before the string is taut

  double taut_time() const;         ///< t1 = sqrt(2 s/g)
  double lowest_time() const;       ///< half the period
  double slack_again_time() const;  ///< t2
  double apex_time() const;         ///< t3, the period
  double largest_drop() const;      ///< length, positive downwards
  double position(double t) const;  ///< y - y(0), length, positive upwards

 private:
  double frequency() const;       ///< of the taut string, radians/time
  double static_stretch() const;  ///< m g/k
  double amplitude() const;       ///< of the motion about the static place
};

}  // namespace tether
