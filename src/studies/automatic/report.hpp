// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/process.hpp"
#include "studies/automatic/automatic.hpp"
#include "studies/automatic/search.hpp"
#include "studies/table.hpp"

namespace tether::automatic {

/// A run that was made, and where.
struct TrialRun {
  Trial trial;
  std::vector<std::string> settings = {};  ///< in place of the deck's
  Ending ending = {};
  std::filesystem::path folder = {};
  bool varied = false;  ///< its steps differ a little from a trial's: it shows whether the number scatters
};

/// A row a run, with what the search came to know of it at its end.
StudyTable table_of(const std::vector<TrialRun>& made, const Search& search);

/// Returns what was tried, what was chosen and why, for people; `chosen` is its place among the runs.
std::string report_text(const Automatic& automatic, const Search& search, const std::vector<TrialRun>& made,
                        std::optional<std::size_t> chosen, const StudyTable& table);

}  // namespace tether::automatic
