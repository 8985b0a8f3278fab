// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "base/process.hpp"
#include "deck/deck.hpp"
#include "plan/load.hpp"
#include "studies/reproduce/read_formula.hpp"
#include "studies/study_checks.hpp"

namespace tether {

/// What runs may write: keys of summary.txt, columns of history.txt.
struct Written {
  std::vector<std::string> keys, columns;
};

/// Returns what the run of a scene may write.
Written written_by(const Loaded& loaded);

/// Builds a run's scene without a step, and adds what the run may write where `written` is given. How that ended.
Ending try_scene(const std::string& name, const Deck& deck, Written* written);

/// The reading that stands in `name`; names that no run writes are mistakes at their columns, as others are.
published::Readout checked_reading(const Deck& deck, TextVariable name, const Written& written, StudyRemarks& remarks);

}  // namespace tether
