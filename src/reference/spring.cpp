// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/spring.hpp"

#include <cmath>
#include <numbers>

namespace tether {

double SpringMass::frequency() const { return std::sqrt(stiffness / mass); }
double SpringMass::period() const { return 2 * std::numbers::pi / frequency(); }
double SpringMass::static_stretch() const { return mass * gravity / stiffness; }
double SpringMass::largest_drop() const { return 2 * static_stretch(); }
double SpringMass::position(double t) const { return -static_stretch() * (1 - std::cos(frequency() * t)); }

}  // namespace tether
