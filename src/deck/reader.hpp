// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"

namespace tether {

/// Warns of what reads well but can hardly be meant, as the thesis' boxes show it. Groups beside $study are errors.
void check_deck(const Deck& deck, Diagnostics& diagnostics);

/// Errors: no $in, and required variables without a value, at the place where the deck left them empty if it did.
/// `mentioned` are those that the deck tried to set: of those enough was said.
void check_required(const Deck& deck, const std::set<std::string>& mentioned,
                    const std::map<std::string, Place>& left_empty, Diagnostics& diagnostics);

/// Reads a deck from text. All mistakes and slips go into `diagnostics`; the deck holds what could be understood.
/// `overrides` are `group.name=value` or `group.name(i,j)=value` from the command line, in deck spelling; their places
/// name the file "--set".
/// Source: the namelist groups of the thesis' boxes 1-16, as gfortran reads them, and what was relaxed for them.
Deck read_deck(std::string_view text, const std::string& file, const std::vector<std::string>& overrides,
               Diagnostics& diagnostics);

}  // namespace tether
