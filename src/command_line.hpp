// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "pictures.hpp"
#include "plan/load.hpp"
#include "run_options.hpp"

namespace tether {

/// What a command line may say: the parser, its commands, and what they found. It must stay where it is, since the
/// parser writes into it.
struct CommandLine {
  CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  CLI::App app;
  DeckOptions deck_options;
  RunOptions run;
  PublishedOptions published;
  std::vector<std::string> decks;       ///< to run
  std::vector<std::string> studies;     ///< of chart and map
  std::string deck;                     ///< of commands that take one deck or study
  std::vector<std::string> deck_words;  ///< of decks
  std::string into, group;
  bool markdown = false, all = false;
  CLI::App *check, *plan, *sweep, *chart, *map, *reproduce;
  Pictures pictures;
  CLI::App *shipped, *vars, *columns, *keys;

  /// Returns whether what was called makes many runs.
  bool makes_many_runs() const { return *sweep || *chart || *map || *reproduce || run.tolerance.has_value(); }
};

}  // namespace tether
