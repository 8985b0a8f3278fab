// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/regions_of_deck.hpp"
#include "deck/words.hpp"

namespace tether {

std::vector<int> regions_of(const Deck& deck, bool fluid) {
  std::vector<int> regions;
  for (int r = 1; r <= deck.integer("reg", "nreg"); ++r) {
    if ((deck.text("fem", "law", r) == fluid_word) == fluid) regions.push_back(r);
  }
  return regions;
}

bool has_flow(const Deck& deck) { return deck.has_group("flow") || !regions_of(deck, true).empty(); }

}  // namespace tether
