// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "studies/assignment.hpp"
#include "studies/reproduce/formula.hpp"
#include "studies/reproduce/problem.hpp"

namespace tether::published {

/// The formula that a text is. Mistakes are noted at their columns of the whole text, in which this one begins at byte
/// `begin`; a formula with a mistake must not be evaluated.
std::shared_ptr<const Formula> read_formula(const std::string& text, std::size_t begin, std::vector<Mistake>& mistakes);

/// A reading taken apart; where there are mistakes, the rest means nothing.
struct ReadReading {
  Readout reading;
  bool of_deck = false;  ///< it needs the deck that ran and nothing that the run wrote
  std::vector<Mistake> mistakes;
  std::vector<std::string> keys = {}, columns = {};  ///< of summary.txt and of history.txt that it reads
};

/// A number of a finished run as a deck asks for it: an expression (base/expression.hpp) of keys of summary.txt and of
/// the functions of reading_functions.hpp, such as "1e3*(first(body_y_3) - min(body_y_3))". Functions of points and of
/// nodes take expressions of their fields: "points_mean(sxx + syy, body == 3, last)".
ReadReading read_reading(const std::string& text);

}  // namespace tether::published
