// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "solvers/coupled/flow_domain.hpp"

namespace tether::coupled {

/// Gives the faces that solids close velocities of the fluid around, so that a face that opens has one: layer after
/// layer, the mean of the neighbours, on the lattice of the same axis, that have one already. Open and prescribed faces
/// keep theirs; what no layer reaches becomes 0. A layer's faces are independent of each other.
void extend_velocity(const FlowDomain& domain, FaceValues& v, int layers);

/// The same of pressures, a number a cell: cells of solids and obstacles get those of the fluid around, so that a cell
/// that fluid comes into has one.
void extend_pressure(const FlowDomain& domain, std::vector<double>& p, int layers);

}  // namespace tether::coupled
