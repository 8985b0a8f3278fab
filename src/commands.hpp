// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "plan/load.hpp"
#include "run_options.hpp"

namespace tether {

/// Version, git hash and libraries.
std::string version_text();

// Each command reports its errors on stderr and returns the exit code; of several decks all are run and the worst
// counts.
int run_command(const std::vector<std::string>& decks, const DeckOptions& options, const RunOptions& run_options);
int check_command(const std::string& deck, const DeckOptions& options, bool all);
int plan_command(const std::string& deck, const DeckOptions& options, int threads);
int vars_command(const std::string& group, bool markdown);
int columns_command(bool markdown);
/// The keys of summary.txt.
int keys_command(bool markdown);
/// Lists the decks that come with the program, or copies one of them, 'get NAME', into a folder.
int decks_command(const std::vector<std::string>& words, const std::string& into);
/// Hands the words over to the script of post/ with the command's name.
int script_command(const std::string& command, const std::vector<std::string>& words);

}  // namespace tether
