// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>

#include "deck/deck.hpp"

namespace tether {

/// What can be said of a deck as a whole. Errors: no $in, and required variables that are not in it (`mentioned` are
/// those that the deck tried to set: of those enough was said). Warnings: what reads well but can hardly be meant, as
/// the thesis' boxes show it.
void check_deck(const Deck& deck, const std::set<std::string>& mentioned, Diagnostics& diagnostics);

}  // namespace tether
