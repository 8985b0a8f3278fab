// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laws/hyperelastic.hpp"

namespace tether {

/// A thick round ring of one law in plane strain, at rest under a pressure inside and nothing outside.
struct ThickRing {
  double inner = 0, outer = 0;  ///< radii without pressure [length]
  ElasticLaw law;
};

/// The ring at rest with a given inner radius. Numbers are those of the whole ring, of unit depth.
struct BlownRing {
  double inner = 0, outer = 0;  ///< radii [length]
  double pressure = 0;          ///< inside [stress]
  double energy = 0;            ///< strain energy [energy]
};

/// Solves the balance of a ring whose points move from R to r(R), with the stretches a = dr/dR and b = r/R and the
/// principal stresses P = dPsi/da and Q = dPsi/db:
///   dP/dR = (Q - P)/R,  P = 0 at the outer radius,  pressure = -P/b at the inner one.
/// The stretch a at the inner radius is found by shooting; the equation is solved by Dormand and Prince's method.
/// A law of small strains has the balance of the radii without pressure, where b = 1 at the inner one.
/// Throws std::domain_error for radii that are not 0 < inner < outer, a radius that is not positive, and where no ring
/// of the law is at rest with it.
BlownRing blown_ring(const ThickRing& ring, double inner);

}  // namespace tether
