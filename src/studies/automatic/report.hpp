// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/automatic/automatic.hpp"
#include "studies/automatic/model_search.hpp"
#include "studies/automatic/search.hpp"
#include "studies/automatic/trial_runs.hpp"
#include "studies/table.hpp"

namespace tether::automatic {

/// A row a run, with what the search came to know of it at its end.
StudyTable table_of(const std::vector<TrialRun>& made, const Search& search);

/// A search that has come to its end. The references must outlive this.
struct Ended {
  const Automatic& automatic;
  const Search& search;
  const Simplified& simplified;
  const std::vector<TrialRun>& made;
  std::optional<std::size_t> chosen;  ///< its place among the runs
};

/// Returns what was tried, what was chosen and why, for people.
std::string report_text(const Ended& ended, const StudyTable& table);

}  // namespace tether::automatic
