// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "results/results.hpp"
#include "unit/full_length.hpp"

namespace tether::cases {

using test::at_full_length;

/// A finished run of a deck of decks/, read from what it left.
struct DeckRun {
  std::map<std::string, double> summary;
  History history;
  std::vector<std::string> warnings;  ///< of the plan
  std::vector<std::string> messages;  ///< warnings of the run
  std::string folder;
  std::shared_ptr<void> keeps_folder;  ///< the folder goes with the last copy of the run

  double first(const std::string& column) const { return history.column(column).front(); }
  double last(const std::string& column) const { return history.column(column).back(); }
};

/// Runs decks/NAME.in as the program does, with overrides as of --set, into a folder of the test's own.
DeckRun run_deck(const std::string& name, const std::vector<std::string>& overrides = {});

/// The same with a deck's text; `name` is what the folder is called after.
DeckRun run_text(const std::string& name, const std::string& text, const std::vector<std::string>& overrides = {});

/// The same with a deck's file, anywhere.
DeckRun run_file(const std::string& path, const std::vector<std::string>& overrides = {});

/// Runs decks/paths/DECK.in, a scene that several paths share, by one of them.
DeckRun run_by(const std::string& path, const std::string& deck, std::vector<std::string> overrides = {});

/// These overrides and more.
std::vector<std::string> with(std::vector<std::string> some, const std::vector<std::string>& more);

/// A variable of a NetCDF file, all of it.
std::vector<double> read_variable(const std::string& file, const std::string& name);

}  // namespace tether::cases
