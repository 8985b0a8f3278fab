// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/team.hpp"
#include "model/coupled.hpp"
#include "physics/box/outside.hpp"

namespace tether::coupled {

/// Carries what faces hold along with the velocity v, which does not change meanwhile, for a time h. Each open face
/// gets what was where the fluid comes from: back by the mid-point rule, and linear between faces (semi-Lagrangian), of
/// order 1; or with the error seen when this is carried forth again taken off by half, within the extrema of what was
/// used (MacCormack), of order 2. Where a solid comes between the faces used, or a path ends before its time,
/// this correction is left out.
///
/// Paths never go through a solid, nor is anything used that lies beyond one (FlowPaths). What comes in through a side
/// has the value there. Prescribed and closed faces keep what they carry, those of v should have been extended
/// (extend_velocity). `out` must be neither `v` nor `carried`. Source: Selle, Fedkiw, Kim, Liu, Rossignac, J. Sci.
/// Comput. 35, 350 (2008).
void carry(Team& team, const FlowDomain& domain, const FaceValues& v, const FaceValues& carried, double h,
           Advection advection, FaceValues& out);

/// The velocity, carried along with itself.
void carry_velocity(Team& team, const FlowDomain& domain, const FaceValues& v, double h, Advection advection,
                    FaceValues& out);

}  // namespace tether::coupled
