// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "studies/reproduce/formula.hpp"

namespace tether::published {

/// What an argument of a function is.
enum class ArgumentKind {
  word,      ///< a name: a column of the history, a field, a key, a value of the deck
  number,    ///< a formula of keys and functions
  of_each,   ///< a formula of the fields of points or nodes
  snapshot,  ///< first, last, or a number from 0
};

/// A function that a reading may have.
struct ReadingFunction {
  std::string name;
  std::vector<ArgumentKind> arguments;
  bool of_deck;         ///< it needs the deck that ran and nothing else
  std::string meaning;  ///< for the guide, a sentence
  double (*value)(const RunFiles& run, const std::vector<Argument>& arguments);
};

std::span<const ReadingFunction> reading_functions();

/// The one of this name, or null.
const ReadingFunction* find_reading_function(const std::string& name);

}  // namespace tether::published
