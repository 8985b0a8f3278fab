// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "studies/study.hpp"
#include "studies/study_remarks.hpp"

namespace tether {

// What is checked of a study as a whole, before its first run; mistakes are told at the study deck's places.

/// What its mode needs is there, and nothing that only other modes know.
void check_mode(const Deck& deck, Mode mode, StudyRemarks& remarks);

/// The base decks read with the values of the first combination (the decks' own mistakes go into `diagnostics`), and
/// the quantities, the criterion and the order are what their runs write.
void check_decks(const Deck& deck, const Study& study, StudyRemarks& remarks, Diagnostics& diagnostics);

}  // namespace tether
