// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "grid/crossings.hpp"
#include "physics/box/outside.hpp"
#include "physics/box/surface_pieces.hpp"

namespace tether::coupled {

/// What cutting the cells makes of a domain whose cells are wholly fluid or not.
///
/// A face's velocity moves the fluid V in the box about it, from one cell's middle to the next, and goes through the
/// box's mean open area V / d. Both follow from the surface by the divergence theorem. So the fluid's mass is exact, a
/// pressure that is linear in place is held by linear pressures at the middles, and a solid that moves without
/// deforming, in a fluid that moves with it, asks for no flow: B then has the pressure, linear between two middles
/// along the axis of the force. (With the open part of the face itself, as is usual, the first two hold to second order
/// in the cells' size.)
struct CutCells {
  FaceValues fluid;                ///< V of each face [volume]
  std::vector<std::uint8_t> thin;  ///< cells where a solid is thinner than a cell: they and their faces are left whole
};

/// `pieces` must be cut by two boxes a cell. `whole` is the domain that FlowBox leaves of the same solids.
CutCells cut_cells(const SurfacePieces& pieces, const Crossings& crossings, const FlowDomain& whole);

}  // namespace tether::coupled
