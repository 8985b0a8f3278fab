// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/string_bounce.hpp"

#include <cmath>

namespace tether {

double StringBounce::frequency() const { return std::sqrt(stiffness / mass); }
double StringBounce::static_stretch() const { return mass * gravity / stiffness; }

/// The string is taut at m g/k above the static place, with the speed sqrt(2 g s) of the fall.
double StringBounce::amplitude() const {
  return std::hypot(static_stretch(), std::sqrt(2 * gravity * slack) / frequency());
}

double StringBounce::taut_time() const { return std::sqrt(2 * slack / gravity); }

/// Depth below the static place is amplitude cos(omega (t - lowest_time)), and -m g/k when the string is taut.
double StringBounce::lowest_time() const {
  return taut_time() + std::acos(-static_stretch() / amplitude()) / frequency();
}

double StringBounce::slack_again_time() const { return 2 * lowest_time() - taut_time(); }
double StringBounce::apex_time() const { return 2 * lowest_time(); }
double StringBounce::largest_drop() const { return slack + static_stretch() + amplitude(); }

double StringBounce::position(double t) const {
  // The motion is the same forwards and backwards from every lowest point, so half a period tells all.
  const double since_lowest = std::abs(std::fmod(t, apex_time()) - lowest_time());
  if (since_lowest >= lowest_time() - taut_time()) {
    const double from_apex = lowest_time() - since_lowest;
    return -gravity * from_apex * from_apex / 2;
  }
  return -(slack + static_stretch() + amplitude() * std::cos(frequency() * since_lowest));
}

}  // namespace tether
