// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solvers/coupled/flow_domain.hpp"

namespace tether::coupled {

/// What fluid about cut faces gives to each other in a step as it goes by.
///
/// A pressure moves the fluid of a face as fast, however little a solid leaves there. No path leads to such a face but
/// from itself, so that it would be faster step by step; and what is carried to whole faces beside it takes its
/// velocity for theirs, which multiplies its energy. In truth little fluid is swept along by much: in the time in which
/// the fastest of them crosses a cell, a face takes, for the part that it lacks, the mean of its own velocity and those
/// of the faces beside it that fluid joins it to, by their volumes. A difference of pressure dp then makes a jet of
/// sqrt(dp/rho), at steps of any length. Whole faces keep their velocities, and none leaves the bounds of those that
/// were.
void blend_cut_faces(const FlowDomain& domain, double h, FaceValues& v);

}  // namespace tether::coupled
