// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"
#include "model/scene.hpp"

namespace tether {

/// Output intervals by the iout/tiout switches. The history has all its columns whichever of 33, 34, 38 is on and takes
/// the shortest of their intervals (a 200th of tmax where none is on); 13, 32, 35, 36 and 40 write all point fields;
/// 30, 31, 37 and 39 all grid fields.
OutputIntervals outputs_of(const Deck& deck, const Scene& scene, Diagnostics& diagnostics);

}  // namespace tether
