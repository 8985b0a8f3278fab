// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "studies/automatic/automatic.hpp"
#include "studies/runs/scheduler.hpp"

namespace tether::automatic {

/// What a search came to.
struct Found {
  std::string report;            ///< for people
  std::filesystem::path folder;  ///< of the chosen run; empty where nothing is promised
  std::string why_not;           ///< why nothing is; else empty
};

/// The chosen deck, below the folder of the search: that of the chosen run with all its values.
constexpr const char* chosen_deck = "chosen.in";

/// Tries what the model can do without, looks for the cheapest setting of what is left, and writes auto.csv, auto.nc (a
/// row a run), auto.txt (the report) and the chosen deck. What was run before is not run again. Throws FileError,
/// Interrupted.
Found find_setting(const Automatic& automatic, const StudyOptions& options);

/// The first runs, a line each: whether it is finished, its deck, its values.
std::string list_first_runs(const Automatic& automatic, const std::filesystem::path& out);

}  // namespace tether::automatic
