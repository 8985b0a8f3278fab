// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solvers/coupled/flow_domain.hpp"

namespace tether::coupled {

/// Adds what friction in the fluid does to the velocities of the open faces in a time h, nu [area/time] being its
/// kinematic viscosity: forward steps of nu times the Laplacian of each component, equal ones and as many as keep every
/// weight positive. Returns how many (about 3 dim h nu / d^2; none where nu is 0).
///
/// Walls, obstacles and jets (prescribed faces) hold what flows along them where `walls_no_slip`, at half a cell's
/// distance; else only what meets them. Along solids and open sides nothing is exchanged, nor through a solid.
int add_viscosity(const FlowDomain& domain, FaceValues& v, double nu, double h, bool walls_no_slip);

}  // namespace tether::coupled
