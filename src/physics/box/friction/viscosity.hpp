// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "physics/box/friction/strain_rates.hpp"

namespace tether::coupled {

/// The solids' nodes while friction acts, dim numbers each: the fluid's momentum goes to those that it sticks to, so
/// that bodies of any mass are dragged along and no further.
struct RubbedNodes {
  std::vector<double> mobility;    ///< 1 / mass of each; 0 where its velocity is held [1/mass]
  std::span<const double> u;       ///< velocities [velocity]
  std::span<const double> driven;  ///< by all but the fluid's friction, in the step before [acceleration]
};

/// A fluid that rubs, in a domain whose faces have velocities.
struct RubbingFluid {
  const FlowDomain& domain;
  double density = 1, mu = 0;  ///< [mass/volume], [stress time]
  const CellParts& parts;      ///< of the cells that are fluid: those of a liquid with a surface
  Beyond beyond = Beyond::fluid;
  const SolidsBeside* solids = nullptr;  ///< null: none cuts the cells
};

/// What friction did.
struct Rubbed {
  int iterations = 0;
  double taken = 0;             ///< of the fluid's kinetic energy [energy]
  std::vector<double> impulse;  ///< that the fluid gave the nodes [momentum]
};

/// Adds what friction in the fluid does to the velocities of the open faces in a time h. They become, with those of the
/// solids' nodes u, the ones of which
///     1/2 sum m (v - v*)^2 + h (half the power that friction takes)
/// is least: (13) of C. Batty, R. Bridson, Proc. SCA (2008) 219-228, implicit and stable for any h. Here the nodes are
/// not prescribed but found with the fluid, so that momentum is kept. Throws RunError where conjugate gradients, of
/// this `tolerance`, do not converge.
///
/// Walls, obstacles and jets (prescribed faces) hold what flows along them, at half a cell's distance, but for sides of
/// the box that slip; bodies do where the fluid sticks to them, else it slips along them. No stress acts
/// at a liquid's surface, and nothing is exchanged through a solid.
///
/// `driven` is the acceleration by pressures and forces that these faces had in the step before. It acts meanwhile, and
/// at the end h times it is taken back, for the pressure to find anew: what stays is what viscosity does to a velocity
/// that is driven as it goes (J. Kim and P. Moin, J. Comput. Phys. 59 (1985) 308-323, by the pressure's gradient of the
/// step before). A steady flow then is one whatever h, since there -nu times the Laplacian is what drives it; without,
/// friction wears it down for all of h before the pressure gives back a change that walls do not see.
Rubbed add_viscosity(Team& team, const RubbingFluid& fluid, const RubbedNodes& nodes, double h, double tolerance,
                     const FaceValues& driven, FaceValues& v);

}  // namespace tether::coupled
