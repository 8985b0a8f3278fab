// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

#include "base/words.hpp"
#include "deck/deck.hpp"

namespace tether {

/// The enumerator that a deck's text stands for, at (i, j) of a variable whose choices are the words of E. Throws
/// std::logic_error where the table has other choices.
template <class E>
E word(const Deck& deck, std::string_view group, std::string_view name, int i = 1, int j = 1) {
  const std::string text = deck.text(group, name, i, j);
  if (const auto found = find_word<E>(text)) return *found;
  throw std::logic_error("'" + text + "' is no word of " + std::string(group) + "." + std::string(name));
}

/// The same, or `otherwise` where the deck does not give the variable.
template <class E>
E word_or(const Deck& deck, std::string_view group, std::string_view name, E otherwise) {
  return deck.given(group, name) ? word<E>(deck, group, name) : otherwise;
}

}  // namespace tether
