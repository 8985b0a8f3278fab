// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "model/coupled.hpp"
#include "solvers/coupled/flow_domain.hpp"

namespace tether::coupled {

/// What a box has exchanged since the start: each number is the sum of its own terms, step by step [energy].
struct EnergyBooks {
  // What came in.
  double jets = 0;        ///< by their pressure, and carried in
  double open_sides = 0;  ///< by the pressure outside, on solids, too, and carried in: also from voids
  double gravity = 0;     ///< work of gravity on the fluid
  double buoyancy = 0;    ///< work of smoke and warmth on it
  double loads = 0;       ///< work of loads and moved supports on the solids
  // What went out or became heat.
  double viscous = 0;  ///< what viscosity took
  double damped = 0;   ///< what the solids' damping took
  double contact = 0;  ///< what walls, obstacles and friction took of the solids
  // What the method lost.
  double advected = 0;    ///< as the fluid carried its velocity along
  double remeshed = 0;    ///< as faces opened and closed at moving solids, and small ones took over their neighbours'
  double projected = 0;   ///< by pressures that act a whole step at its end's velocity
  double sources = 0;     ///< by the volume term
  double coupling = 0;    ///< what the fluid gave less what the solids took
  double solid_step = 0;  ///< what the solids' forces took in a step less what is stored of it
};

/// Kinetic energy that velocities carry in a time through the box's openings.
struct CarriedIn {
  double jets = 0, open_sides = 0;  ///< negative: out [energy]
};

/// Through faces of the box's sides, and those to voids, as open sides: rho |v|^2/2 times the flux; along a face the
/// square is the mean of those on both sides of the fluid's cell.
CarriedIn carried_in(const Coupled& scene, const FlowDomain& domain, const FaceValues& v, double h);

/// a.b
double product(std::span<const double> a, std::span<const double> b);

}  // namespace tether::coupled
