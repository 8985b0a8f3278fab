// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"

namespace tether {

/// Reads a deck from text. All mistakes and slips go into `diagnostics`; the deck holds what could be understood.
/// `overrides` are `group.name=value` or `group.name(i,j)=value` from the command line, in deck spelling; their places
/// name the file "--set".
/// Source: the namelist groups of the thesis' boxes 1-16, as gfortran reads them, and what was relaxed for them.
Deck read_deck(std::string_view text, const std::string& file, const std::vector<std::string>& overrides,
               Diagnostics& diagnostics);

}  // namespace tether
