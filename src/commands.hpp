// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace tether {

// Exit codes of the contract.
constexpr int exit_done = 0, exit_input = 2, exit_run = 3, exit_file = 4;

/// How a deck is to be read.
struct DeckOptions {
  std::vector<std::string> overrides;  ///< group.name=value
  std::string particles;               ///< empty: what the deck names
  std::string path = "mpm";
};

struct RunOptions {
  std::string out;  ///< empty: out/<deck name>
  int threads = 1;
  bool quiet = false;
  bool dry_run = false;
  std::string command;  ///< as it was typed, for provenance
};

/// Version, git hash and libraries.
std::string version_text();

// Each command tells its errors on stderr and returns the exit code; of several decks all are run and the worst counts.
int run_command(const std::vector<std::string>& decks, const DeckOptions& options, const RunOptions& run_options);
int check_command(const std::string& deck, const DeckOptions& options);
int plan_command(const std::string& deck, const DeckOptions& options);
int vars_command(const std::string& group, bool markdown);

}  // namespace tether
