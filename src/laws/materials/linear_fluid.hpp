// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace tether {

/// The piston's fluid (6.1): p = -beta div U, so that pressure accumulates strain instead of following density.
struct LinearFluid {
  double beta = 0;  // bulk modulus [stress]

  double updated_pressure(double p, double divergence, double dt) const { return p - beta * divergence * dt; }
  double energy_density(double p) const { return p * p / (2 * beta); }
  double sound_speed(double density) const { return std::sqrt(beta / density); }
};

}  // namespace tether
