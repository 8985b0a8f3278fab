// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tether {

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

}  // namespace tether
