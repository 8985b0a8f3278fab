// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "run_options.hpp"

namespace tether {

// Commands that make many runs. Each reports its errors on stderr and returns the exit code; of several decks all are
// run and the worst counts.
int sweep_command(const std::string& study, const RunOptions& options);
int chart_command(const std::vector<std::string>& studies, const RunOptions& options);
int map_command(const std::vector<std::string>& studies, const RunOptions& options);
int reproduce_command(const PublishedOptions& published, const RunOptions& options);

}  // namespace tether
