// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>
#include <string>

#include "deck/deck.hpp"

namespace tether {

/// What reads well but can hardly be meant, as the thesis' boxes show it: warnings. Errors: groups beside $study.
void check_deck(const Deck& deck, Diagnostics& diagnostics);

/// Errors: no $in, and required variables without a value, at the place where the deck left them empty if it did.
/// `mentioned` are those that the deck tried to set: of those enough was said.
void check_required(const Deck& deck, const std::set<std::string>& mentioned,
                    const std::map<std::string, Place>& left_empty, Diagnostics& diagnostics);

}  // namespace tether
