// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/diagnostics.hpp"
#include "base/expression.hpp"
#include "base/words.hpp"
#include "deck/deck.hpp"
#include "model/solids.hpp"

namespace tether {

/// The enumerator that a deck's text stands for, at (i, j) of a variable whose choices are the words of E. Throws
/// std::logic_error where the table has other choices.
template <class E>
E word(const Deck& deck, TextVariable variable, int i = 1, int j = 1) {
  const std::string text = deck.text(variable, i, j);
  if (const auto found = find_word<E>(text)) return *found;
  throw std::logic_error("'" + text + "' is no word of " + std::string(variable.name()));
}

/// Returns the same, or `otherwise` where the deck does not give the variable.
template <class E>
E word_or(const Deck& deck, TextVariable variable, E otherwise) {
  return deck.given(variable) ? word<E>(deck, variable) : otherwise;
}

/// The expression in these variables that a text of the deck is, or null where it is wrong, which is reported under the
/// byte that is.
std::shared_ptr<const Expression> expression_of(const Deck& deck, TextVariable name, int k,
                                                std::vector<std::string> variables, Diagnostics& diagnostics);

/// Adds an error on an element's value, at its place.
void refuse(const Deck& deck, AnyVariable name, Subscript at, const std::string& message, const std::string& hint,
            Diagnostics& diagnostics);

/// Returns whether an element of a variable has the value that it has where the deck does not give it.
bool is_default(const Deck& deck, AnyVariable name, Subscript at);

/// Returns whether the deck has a fluid on a mesh: $flow, or a region of the law 'fluid'.
bool has_flow(const Deck& deck);
/// Returns whether the path that the deck names has region r: `paths` of $reg may leave it to others.
bool has_region(const Deck& deck, int r);
/// The deck's numbers, from 1, of all regions that its path has.
std::vector<int> regions_of(const Deck& deck);
/// The deck's numbers, from 1, of the regions that are a fluid, or of those that are not.
std::vector<int> regions_of(const Deck& deck, bool fluid);

/// Says what is wrong with a path that stands in a deck ("is absolute", ...): it counts from the deck's folder and
/// climbs at most one folder. Empty where nothing is wrong.
std::string path_mistake(const std::string& path);

/// Says what would be right, with an example.
std::string path_hint(const std::string& example);

/// The file of that name, counted from the deck's folder.
std::filesystem::path path_beside(const Deck& deck, const std::string& name);

/// The factor that the deck gives as what_time and what_factor in column k, or as what_expression(k) ("fem.load");
/// where it gives neither, a static problem's grows in proportion to time.
Amplitude amplitude_of(const Deck& deck, AnyVariable what, int k, Diagnostics& diagnostics);

}  // namespace tether
