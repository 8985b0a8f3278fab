// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "studies/automatic/automatic.hpp"
#include "studies/automatic/model_search.hpp"
#include "studies/automatic/search.hpp"
#include "studies/automatic/trial_runs.hpp"
#include "studies/table.hpp"

namespace tether::automatic {

/// A row a run, with what the search came to know at its end of those that are its own.
StudyTable table_of(const std::vector<TrialRun>& made, const Search& search);

/// A search that has come to its end. The references must outlive this.
struct Ended {
  const Automatic& automatic;
  const Search& search;
  const Simplified& simplified;
  const TrialRuns& runs;
};

/// Returns what was tried, what was chosen and why, for people.
std::string report_text(const Ended& ended, const StudyTable& table);

}  // namespace tether::automatic
