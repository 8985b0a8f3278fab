// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"
#include "grid/geometry.hpp"

namespace tether {

/// By cyl: a plane scene, or one about the axis x = 0.
Geometry geometry_of(const Deck& deck);

/// Tells where the grid or its left wall cannot be what a scene about an axis needs.
void check_axis(const Deck& deck, Diagnostics& diagnostics);

}  // namespace tether
