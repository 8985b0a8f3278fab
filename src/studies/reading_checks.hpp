// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "deck/deck.hpp"
#include "studies/reproduce/read_formula.hpp"
#include "studies/study_checks.hpp"

namespace tether {

/// What runs may write: keys of summary.txt, columns of history.txt.
struct Written {
  std::vector<std::string> keys, columns;
};

/// Adds what a run of this deck may write; its scene is built without a step. Throws InputError where it cannot be.
void add_written(const Deck& deck, Written& written);

/// The reading that stands in `name`; names that no run writes are mistakes at their columns, as others are.
published::Readout checked_reading(const Deck& deck, TextVariable name, const Written& written, StudyRemarks& remarks);

}  // namespace tether
