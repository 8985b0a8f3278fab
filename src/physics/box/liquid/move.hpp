// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/box/liquid/exits.hpp"
#include "physics/box/liquid/hats.hpp"
#include "physics/box/liquid/near_solids.hpp"
#include "physics/box/liquid/particles.hpp"
#include "physics/box/outside.hpp"

namespace tether::liquid {

/// Carries the particles along for a time h, by the mid-point rule, in parts in which none crosses more than a cell. No
/// way goes through a wall, an obstacle or a face that a solid closes; what meets a side of the box goes on along it,
/// unless an exit is there. Sides that
/// are `held` have no velocity along them. Returns of each particle whether it left.
std::vector<std::uint8_t> carry_particles(Team& team, const coupled::FlowDomain& room, const coupled::FaceValues& v,
                                          const HeldSides& held, const Exits& exits, double h, Particles& particles);

/// Moves particles by ways that a field of the faces gives, no more than `most` cells along each axis.
void shift_particles(Team& team, const coupled::FlowDomain& room, const coupled::FaceValues& ways, double most,
                     Particles& particles);

/// Takes out of the solids what came into them: to just before the nearest place of the surface, whose nodes have the
/// velocities u (those beyond rest). What they had towards the solid they lose.
void put_out_of_solids(Team& team, const StaggeredGrid& grid, const NearSolids& solids, std::span<const double> u,
                       Particles& particles);

}  // namespace tether::liquid
