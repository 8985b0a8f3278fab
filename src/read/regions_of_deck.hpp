// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "deck/deck.hpp"

namespace tether {

/// Whether the deck has a fluid on a mesh: $flow, or a region of the law 'fluid'.
bool has_flow(const Deck& deck);
/// The deck's numbers, from 1, of the regions that are a fluid, or of those that are not.
std::vector<int> regions_of(const Deck& deck, bool fluid);

}  // namespace tether
