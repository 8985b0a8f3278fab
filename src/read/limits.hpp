// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"
#include "grid/boxes.hpp"
#include "model/method.hpp"
#include "model/scene.hpp"

namespace tether {

/// Returns what $limits says, by default what Limits has. `solids`, where there are any, set what is a doubtful volume
/// of an element.
Limits limits_of(const Deck& deck, const Solids* solids, Diagnostics& diagnostics);

/// Why a grid with so many points cannot be held, with the memory it would need; empty where it can. Counts against
/// the machine's physical memory, and the node numbers' range.
std::string memory_refusal(const BackgroundGrid& grid, double points);

/// Does the same for a fluid's cells, with the systems that couple it to bodies.
std::string memory_refusal(const StaggeredGrid& grid);

/// Output intervals by the iout/tiout switches. The history has all its columns whichever of 33, 34, 38 is on and takes
/// the shortest of their intervals (a 200th of tmax where none is on); 13, 32, 35, 36 and 40 write all point fields;
/// 30, 31, 37 and 39 all grid fields.
OutputIntervals outputs_of(const Deck& deck, const Scene& scene, Diagnostics& diagnostics);

}  // namespace tether
