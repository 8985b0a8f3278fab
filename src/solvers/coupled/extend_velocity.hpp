// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solvers/coupled/flow_domain.hpp"

namespace tether::coupled {

/// Gives the faces that solids close velocities of the fluid around, so that a face that opens has one: layer after
/// layer, the mean of the neighbours, on the lattice of the same axis, that have one already. Open and prescribed faces
/// keep theirs; what no layer reaches becomes 0. A layer's faces are independent of each other.
void extend_velocity(const FlowDomain& domain, FaceValues& v, int layers);

}  // namespace tether::coupled
