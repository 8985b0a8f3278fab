// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "plan/load.hpp"
#include "run_options.hpp"

namespace tether {

// Commands that make many runs. Each reports its errors on stderr and returns the exit code; of several decks all are
// run and the worst counts.
int sweep_command(const std::string& study, const RunOptions& options);
int chart_command(const std::vector<std::string>& studies, const RunOptions& options);
int map_command(const std::vector<std::string>& studies, const RunOptions& options);
/// The cheapest setting of each deck that meets options.tolerance, run as the deck itself would be.
int auto_command(const std::vector<std::string>& decks, const DeckOptions& deck_options, const RunOptions& options);
/// Does the same for one deck, and prints the plan of that setting in place of its results.
int auto_plan_command(const std::string& deck, const DeckOptions& deck_options, const RunOptions& options);
int reproduce_command(const PublishedOptions& published, const RunOptions& options);

}  // namespace tether
