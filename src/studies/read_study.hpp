// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"
#include "studies/study.hpp"

namespace tether {

/// Reads a study deck and the decks that it names. Throws InputError with every mistake, FileError where the study deck
/// cannot be read. A chart is none.
Study read_study(const std::string& file);

/// The study deck alone. Throws as above where it is none.
Deck read_study_deck(const std::string& file, Diagnostics& diagnostics);
/// Returns what all modes have in common of a study deck, and what its own mode has but for a chart's families.
Study study_of(const Deck& deck, Diagnostics& diagnostics);

}  // namespace tether
