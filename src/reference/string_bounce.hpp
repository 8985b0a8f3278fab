// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tether {

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
