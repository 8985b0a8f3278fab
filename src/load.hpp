// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "commands.hpp"
#include "deck/deck.hpp"
#include "plan/plan.hpp"

namespace tether {

/// A deck on its way to a run: what was read, what it asks for, what will be done.
struct Loaded {
  Deck deck;
  Plan plan;
  std::string effective;  ///< text of deck.effective: the deck with all values and its particle data
  std::vector<std::string> warnings;
};

/// Deck, particle file, scene and plan. Throws InputError with every mistake, FileError where the deck cannot be read.
Loaded load(const std::string& file, const DeckOptions& options);

}  // namespace tether
