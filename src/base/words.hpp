// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace tether {

/// An enumerator, and what decks call it.
template <class E>
struct Word {
  E value;
  std::string_view text;
};

/// All words of an enumeration, specialised where it is defined. It is the one list from which the deck's table has its
/// choices, reading the enumerators and messages their names. An enumerator that decks do not name is left out.
template <class E>
inline constexpr std::array<Word<E>, 0> words{};

/// Texts as the deck's table gives choices: "musl|usf|usl". List::texts is an array of them.
template <class List>
struct Joined {
  static constexpr std::size_t size = [] {
    std::size_t sum = List::texts.size() - 1;  // the bars between them
    for (const std::string_view text : List::texts) sum += text.size();
    return sum;
  }();
  static constexpr std::array<char, size> chars = [] {
    std::array<char, size> joined{};
    std::size_t at = 0;
    for (const std::string_view text : List::texts) {
      if (at > 0) joined[at++] = '|';
      for (const char c : text) joined[at++] = c;
    }
    return joined;
  }();
  static constexpr std::string_view text{chars.data(), size};
};

/// The texts of an enumeration's words.
template <class E>
struct TextsOf {
  static constexpr auto texts = [] {
    std::array<std::string_view, words<E>.size()> all;
    for (std::size_t k = 0; k < all.size(); ++k) all[k] = words<E>[k].text;
    return all;
  }();
};

/// The words of an enumeration as the deck's table gives them.
template <class E>
inline constexpr std::string_view choices = Joined<TextsOf<E>>::text;

/// The enumerator of a word, or none.
template <class E>
constexpr std::optional<E> find_word(std::string_view text) {
  for (const auto& word : words<E>) {
    if (word.text == text) return word.value;
  }
  return std::nullopt;
}

/// The word of an enumerator. Throws std::logic_error where decks have none for it.
template <class E>
constexpr std::string_view word_of(E value) {
  for (const auto& word : words<E>) {
    if (word.value == value) return word.text;
  }
  throw std::logic_error("an enumerator has no word");
}

}  // namespace tether
