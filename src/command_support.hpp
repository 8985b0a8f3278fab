// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "run_options.hpp"

namespace tether {

/// Runs the command, tells on stderr what went wrong, and returns the exit code.
int guarded(const std::string& name, const std::function<void()>& command);

/// One deck's own folder: DIR for a single deck, DIR/<deck name> for several, out/<deck name> without --out.
std::filesystem::path folder_of(const std::string& deck, const RunOptions& options, bool several);

/// Two decks of one name would write into one folder; a checkpoint is of one deck. Throws InputError.
void refuse_shared_folders(const std::vector<std::string>& decks, const RunOptions& options);

}  // namespace tether
