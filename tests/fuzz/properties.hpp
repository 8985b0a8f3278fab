// SPDX-License-Identifier: GPL-3.0-or-later
// What must hold for whatever bytes a user gives. A property that fails ends the program, which libFuzzer reports.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"

namespace tether::fuzz {

/// Says what does not hold and ends the program.
void expect(bool holds, const std::string& what);

/// Every remark can be told, and is about a place in `lines` (line 1 first) or about the whole text.
void expect_places_inside(const Diagnostics& diagnostics, const std::vector<std::string>& lines);

/// A deck without errors can be listed, and its deck.effective reads without errors and says the same. Decks of very
/// many values are left out.
void expect_survives(const Deck& deck);

}  // namespace tether::fuzz
