// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "solvers/coupled/pressure_sampler.hpp"

namespace tether::coupled {

/// Of each piece of the surface the open side of the box straight before it, nearer than half a cell and than the
/// middle of the cell before it (`before`, as the sampler finds it); -1: none. The last cell's middle is beyond such a
/// piece, and yet it has no film: what it pushes goes out through the side, whose pressure it feels. Pieces in a side
/// count as before it, those beyond do not.
std::vector<int> open_sides_before(const SurfacePieces& pieces, const FlowDomain& domain,
                                   const PressureSampler& sampler, std::span<const int> before);

}  // namespace tether::coupled
