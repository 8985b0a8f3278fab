// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/study.hpp"

namespace tether {

/// One of the base decks with one value of each axis.
struct Combination {
  std::size_t deck = 0;
  std::vector<std::size_t> values;  ///< for each axis the number of its value
};

/// One run of a study: a combination, the how-manieth of its runs it is, and, in an ensemble or a bisection, the value
/// that is varied.
struct Variant {
  std::size_t combination = 0;
  std::size_t number = 0;
  std::optional<double> varied;
};

/// Number of combinations; linked axes count once.
double count_combinations(const Study& study);

/// All of them in the table's order: axis 1 fastest, as in a Fortran array, decks slowest.
std::vector<Combination> combinations(const Study& study);

/// The --set of a combination's run: those that all share, those of the axes, and the varied value's.
std::vector<std::string> overrides_of(const Study& study, const Combination& combination, std::optional<double> varied);

/// The deck of a run as the reader gives it; its remarks are left to those who run it.
Deck read_deck(const Study& study, const Combination& combination, std::optional<double> varied = {});

/// The factors of an ensemble, evenly from 1 - fraction to 1 + fraction, both included.
std::vector<double> ensemble_factors(double fraction, int runs);

}  // namespace tether
