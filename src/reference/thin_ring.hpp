// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tether {

/// A closed elastic ring in plane strain (no strain along the axis), thin against its radius and without bending
/// stiffness, that gas inside keeps round, vacuum outside. All numbers are those of a quarter of it, of unit depth.
/// Source: thesis 6.2, Tables 4 to 6; the balances are derived here.
struct ThinRing {
  double length = 0;           // unstretched, of the middle line of a quarter [length]
  double thickness = 0;        // [length]
  double young = 0;            // E [stress]
  double poisson = 0;          // nu; 0 for a ring that is stressed along its tangent only
  double gm1 = 0;              // gamma - 1 of the gas
  double internal_energy = 0;  // of the gas before it stretched the ring [energy]
};

/// The ring at rest.
struct RingAtRest {
  double radius = 0;         // of the middle line [length]
  double pressure = 0;       // of the gas, which fills the middle line's circle [stress]
  double hoop_stress = 0;    // [stress]
  double strain_energy = 0;  // of the quarter [energy]
};

/// The ring at rest when nothing was lost: what the gas had at first it shares with the ring's strain,
/// U + S = internal_energy, whatever shape the ring began with and however it swung. The strain is logarithmic and the
/// ring's volume stays, as a membrane point's does, so that its tension is that of the strain energy:
///   eps = ln(r pi / (2 L)),  sigma = E eps / (1 - nu^2)  (5.15),  S = sigma eps L t / 2,
///   p = (gamma - 1) U / (pi r^2 / 4)  (4.4),  p r = sigma t L / (r pi / 2).
/// Throws std::domain_error for numbers that are not positive and finite, nu outside -1 .. 1/2, and gas so strong that
/// it stretches the ring without end.
RingAtRest ring_at_rest(const ThinRing& ring);

}  // namespace tether
