// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "plan/load.hpp"
#include "studies/automatic/choices.hpp"
#include "studies/automatic/refinement.hpp"
#include "studies/automatic/search.hpp"
#include "studies/reproduce/problem.hpp"
#include "studies/study.hpp"

namespace tether::automatic {

/// A deck whose cheapest setting is wanted.
struct Automatic {
  Study study;               ///< the deck with all its values: what each run has in common
  std::string quantity;      ///< as the deck, or its own figure of merit, writes it
  published::Readout value;  ///< of a finished run
  Refinement refinement;
  std::vector<Choice> choices;  ///< what the model may do without
  Aim aim;
  Orders by_elements;  ///< theory's where it is solved by finite elements alone
};

/// Reads a deck and builds its scene, so that every mistake is reported before the first run: a tolerance that is none,
/// a quantity that no run writes, no figure of merit, nothing that could be made finer, a budget that the first runs
/// use up. Throws InputError with all of them, FileError where the deck cannot be read.
Automatic read_automatic(const std::string& file, const DeckOptions& options, double tolerance);

/// The study of one run: the deck with these values in place of its own.
Study study_of_run(const Automatic& automatic, const std::vector<std::string>& overrides);

}  // namespace tether::automatic
