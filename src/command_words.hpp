// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace tether {

/// The words of a command line in the order in which the parser wants them: the command first, whatever stands before
/// it, and "help" as the option it means. The first word that is neither an option nor an option's value is the
/// command, or else a deck. Throws InputError, before anything is done, where it is neither, where a command does not
/// know an option, and where a command for one deck is given several.
std::vector<std::string> ordered_words(const CLI::App& app, const std::vector<std::string>& words);

/// "check, plan, ...", for messages.
std::string command_names(const CLI::App& app);

}  // namespace tether
