// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "studies/scheduler.hpp"

namespace tether {

/// How the published problems are to be run.
struct ReproduceOptions {
  std::filesystem::path decks = "decks";  ///< folder of their decks
  std::filesystem::path out;              ///< folder for the runs
  std::filesystem::path write;            ///< file for the table in Markdown; empty for none
  int jobs = 1;                           ///< runs side by side
  std::string command;                    ///< as it was typed
  std::function<void(const SweepProgress&)> progress;
};

/// What there is to say at the end.
struct ReproduceResult {
  std::string report;                  ///< the table, for a terminal, and why runs failed
  std::vector<std::string> disagreed;  ///< "problem, quantity: verdict" of what is judged and does not agree
  std::size_t file_trouble = 0;        ///< runs that could not read or write a file
};

/// Runs the published problems of these names (none: all), by the thesis' method and by the robust one, and sets what
/// the runs show next to what is published and what is exact. Throws InputError for names that there are not and
/// decks that cannot be understood, FileError, Interrupted.
ReproduceResult reproduce(const std::vector<std::string>& names, const ReproduceOptions& options);

/// The runs, a line each: whether it is finished, its deck, its overrides. Throws as above.
std::string list_published_runs(const std::vector<std::string>& names, const ReproduceOptions& options);

}  // namespace tether
