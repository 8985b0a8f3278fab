// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"

namespace tether {

/// The deck with the text of the mesh file that its $mesh names (relative to the deck, at most one folder up); the deck
/// as it is where it names none, or where the file cannot be read or is not the one that deck.effective meant, which is
/// told.
Deck load_mesh(const Deck& deck, Diagnostics& diagnostics);

}  // namespace tether
