// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"

namespace tether {

/// Whether the deck describes a box of cells and, with $mesh, bodies of as many dimensions, so that a scene can be
/// made; tells what it has instead: $flow, rigid bodies, an axis, a depth without ends.
bool check_coupled_frame(const Deck& deck, Diagnostics& diagnostics);

}  // namespace tether
