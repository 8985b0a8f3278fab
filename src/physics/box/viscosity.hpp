// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "physics/box/drag.hpp"
#include "physics/box/outside.hpp"

namespace tether::coupled {

/// Adds what friction in the fluid does to the velocities of the open faces in a time h, nu [area/time] being its
/// kinematic viscosity: forward steps of nu times the Laplacian of each component, equal ones and as many as keep every
/// weight positive. Returns how many (about 3 dim h nu / d^2; none where nu is 0).
///
/// Walls, obstacles and jets (prescribed faces) hold what flows along them where `walls_no_slip`, at half a cell's
/// distance, but for sides of the box that slip; else only what meets them. Along open sides nothing is exchanged, nor
/// through a solid; with `bodies` the fluid sticks to these, else it slips along them.
///
/// `driven` is the acceleration by pressures and forces that these faces had in the step before. It acts meanwhile, and
/// at the end h times it is taken back, for the pressure to find anew: what stays is what viscosity does to a velocity
/// that is driven as it goes (J. Kim and P. Moin, J. Comput. Phys. 59 (1985) 308-323, by the pressure's gradient of the
/// step before). A steady flow then is one whatever h, since there -nu times the Laplacian is what drives it; without,
/// friction wears it down for all of h before the pressure gives back a change that walls do not see.
///
/// Where `stop` is given, it is asked meanwhile, and where it says so, the velocities are left half-way: -1.
int add_viscosity(const FlowDomain& domain, FaceValues& v, double nu, double h, bool walls_no_slip,
                  const FaceValues* driven = nullptr, const std::function<bool()>& stop = nullptr,
                  StickingBodies* bodies = nullptr);

/// About how many of its own steps viscosity takes in a time h.
double viscous_steps(const StaggeredGrid& grid, double nu, double h);
/// After so many of them it asks whether to stop.
constexpr int steps_between_questions = 100;

}  // namespace tether::coupled
