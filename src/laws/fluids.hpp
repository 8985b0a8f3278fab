// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "base/words.hpp"
#include "laws/tensors.hpp"

namespace tether {

/// How a gas point knows its density: from its cell (4.5), from the nine cells around it (4.6), from continuity (4.7),
/// or from the mass of gas at the nodes.
enum class DensityRule { cell, quadratic, continuity, grid };
template <>
inline constexpr std::array<Word<DensityRule>, 4> words<DensityRule>{{{DensityRule::cell, "cell"},
                                                                      {DensityRule::quadratic, "quadratic"},
                                                                      {DensityRule::continuity, "continuity"},
                                                                      {DensityRule::grid, "grid"}}};

/// 2 mu (eps' - tr(eps') / 3 I), of (4.1)
inline Stress friction_stress(double mu, const StrainRate& d) {
  const double mean = (d.xx + d.yy + d.zz) / 3;
  return {2 * mu * (d.xx - mean), 2 * mu * (d.yy - mean), 2 * mu * d.xy, 2 * mu * (d.zz - mean)};
}

/// Compressible viscous ideal gas (chapter 4).
struct IdealGas {
  double gm1 = 0.4;             // gamma - 1
  double mu = 0;                // shear viscosity [stress time]
  double lambda = 0;            // factor of the artificial viscosity, number
  double coef1 = 0, coef2 = 0;  // its linear and quadratic coefficients, numbers
  DensityRule rule = DensityRule::continuity;
  bool local_speed = false;  // artificial viscosity with the point's own sound speed instead of the largest one

  double pressure(double rho, double i) const { return gm1 * rho * i; }  // (4.4)

  /// Square of the sound speed, gamma p / rho = gamma (gamma - 1) i; none for a gas whose energy was used up.
  double sound_speed_squared(double i) const { return std::max(0.0, (gm1 + 1) * gm1 * i); }

  /// q of (4.11), (4.12): only under compression, D = div v < 0. c is the largest sound speed in the gas, g a length of
  /// the mesh. The thesis' print of q is lost; linear and quadratic term are those of Wilkins (1980).
  double artificial_viscosity(double rho, double c, double g, double D) const {
    if (!(D < 0)) return 0;
    return lambda * rho * (coef1 * c * g * -D + coef2 * g * g * D * D);
  }

  /// sigma = -(p + q) I + 2 mu (eps' - tr(eps') / 3 I)  (4.1)
  Stress stress(double p_plus_q, const StrainRate& d) const {
    const Stress s = friction_stress(mu, d);
    return {s.xx - p_plus_q, s.yy - p_plus_q, s.xy, s.zz - p_plus_q};
  }

  /// rho^{k+1} = rho^k / (1 + dt div v)  (4.7)
  static double continued_density(double rho, double dt, double divergence) { return rho / (1 + dt * divergence); }

  /// i += dt (sigma : eps') / rho  (4.10)
  static double heated(double i, double dt, const Stress& s, const StrainRate& d, double rho) {
    return i + dt * power(s, d) / rho;
  }
};

/// The piston's fluid (6.1): p = -beta div U, so that pressure accumulates strain instead of following density. With
/// viscosity, which the source leaves out, its friction is the gas' of (4.1).
struct LinearFluid {
  double beta = 0;  // bulk modulus [stress]
  double mu = 0;    // shear viscosity [stress time]

  double updated_pressure(double p, double divergence, double dt) const { return p - beta * divergence * dt; }
  double energy_density(double p) const { return p * p / (2 * beta); }
  double sound_speed(double density) const { return std::sqrt(beta / density); }
};

}  // namespace tether
