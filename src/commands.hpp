// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "plan/load.hpp"

namespace tether {

struct RunOptions {
  std::string out;      ///< empty: out/<deck name>
  int threads = 0;      ///< of a run; 0: as many as are worth it
  int jobs = 0;         ///< runs of a sweep side by side
  std::string restart;  ///< checkpoint to go on from; empty: from the start
  bool quiet = false;
  bool dry_run = false;
  std::string command;  ///< as it was typed, for provenance
};

/// Which published problems are wanted, and what is done with them beside what RunOptions say.
struct PublishedOptions {
  std::vector<std::string> names;  ///< none: all
  std::string decks = "decks";     ///< folder of their decks
  std::string write;               ///< file for the table in Markdown; empty for none
};

/// Version, git hash and libraries.
std::string version_text();

// Each command tells its errors on stderr and returns the exit code; of several decks all are run and the worst counts.
int run_command(const std::vector<std::string>& decks, const DeckOptions& options, const RunOptions& run_options);
int check_command(const std::string& deck, const DeckOptions& options);
int plan_command(const std::string& deck, const DeckOptions& options, int threads);
int sweep_command(const std::string& study, const RunOptions& options);
int chart_command(const std::string& study, const RunOptions& options);
int reproduce_command(const PublishedOptions& published, const RunOptions& options);
int vars_command(const std::string& group, bool markdown);
int columns_command(bool markdown);
/// The keys of summary.txt.
int keys_command(bool markdown);

}  // namespace tether
