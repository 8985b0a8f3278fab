// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "deck/deck.hpp"

namespace tether {

/// A deck that reads back with the same values, bit by bit, and shows the defaults too: the header lines, every group
/// with what the deck gives and the defaults of scalars and of regions 1..nreg, the text after the groups.
/// A variable that has no default and is not given is left out.
std::string effective_deck(const Deck& deck);

/// What `tether check` lists of a deck.
struct CheckListing {
  bool all = false;  ///< every variable; else what is given and differs from its default, and how many others there are
  bool colour = false;  ///< for a terminal
};

/// Writes what `tether check` prints. Each variable has a line, and so has each element of an array that the deck
/// gives: name, value, given or default, unit, place, and whether it is read without effect.
std::string check_listing(const Deck& deck, CheckListing how = {});

/// Writes what `tether vars` prints: the rows of a group of the table, or of all groups if `group` is empty; "" for an
/// unknown group.
std::string variables_listing(std::string_view group);

/// The table as Markdown, a section for each group, for the deck reference.
std::string variables_markdown(const std::string& group = "");

}  // namespace tether
