// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"
#include "scene/flow.hpp"
#include "scene/scene.hpp"

namespace tether {

/// Whether the deck has what a fluid's mesh is made of; tells what it has instead: no region that is a fluid, rigid
/// bodies, no $mesh, a mesh file, a depth.
bool check_flow_frame(const Deck& deck, Diagnostics& diagnostics);

/// Tells what the deck asks for beside a fluid and cannot have, and what has no effect.
void check_flow_deck(const Deck& deck, Diagnostics& diagnostics);

}  // namespace tether
