// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "model/liquid.hpp"
#include "physics/box/outside.hpp"
#include "physics/box/surface_pieces.hpp"

namespace tether::liquid {

/// Returns which part of the hat of one cell about each cell's middle lies outside solids and obstacles; walls of the
/// box mirror the hats. `pieces` of the solids' surface must be cut by two boxes a cell: then it is exact, by the
/// divergence theorem.
std::vector<double> open_parts(const coupled::FlowDomain& room, const coupled::SurfacePieces& pieces);

/// The signed distance of each cell's middle from the liquid's surface, below 0 in the liquid [cells].
///
/// It is that of a flat surface which leaves a hat of two cells filled as much as it is, of what solids leave of the
/// hat. Cells of which they leave little have the distances of those next to them: the surface goes on into solids, so
/// that nothing there is at the pressure of the air.
std::vector<double> surface_distances(const StaggeredGrid& grid, std::span<const double> filled,
                                      std::span<const double> open);

/// Where a liquid's surface is.
struct Surface {
  coupled::FlowDomain room;      ///< the domain that solids leave, liquid or not
  std::vector<double> open;      ///< of each cell: open_parts()
  std::vector<double> distance;  ///< of each cell: surface_distances() [cells]
};

/// Returns what of a room, the domain that solids leave, is liquid: cells on its side of the surface. The rest is
/// empty. Faces between the two move the liquid up to the surface, where the pressure is that of the air (F. Gibou et
/// al., J. Comput. Phys. 176 (2002) 205-227: of order 2), but no less than a thousandth of their box. Sealed air, which
/// no opening of the box lets out, is a fluid of a thousandth of the density: its volume stays, and its pressure is all
/// but even.
coupled::FlowDomain liquid_in(const coupled::FlowDomain& room, std::span<const double> distance, Air air);

/// Returns whether a face moves liquid: it is open, and a cell on one of its sides is liquid.
bool moves_liquid(const coupled::FlowDomain& liquid, std::span<const double> distance, int axis, std::size_t face);

}  // namespace tether::liquid
