// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/diagnostics.hpp"
#include "base/process.hpp"
#include "command_support.hpp"
#include "commands.hpp"
#include "shared_files.hpp"
#include "shipped_decks.hpp"

// Commands that use the files that come with the program.

namespace tether {
namespace {

void list_decks() {
  const auto decks = shipped_decks(shared_folder());
  std::size_t width = 0;
  for (const ShippedDeck& deck : decks) width = std::max(width, deck.name.size());
  for (const ShippedDeck& deck : decks) fmt::print("{:<{}}  {}\n", deck.name, width, deck.title);
}

void get_deck(const std::string& name, const std::filesystem::path& into) {
  const auto files = copy_shipped_deck(shared_folder(), name, into);
  for (const auto& file : files) fmt::print("{}\n", file.string());
}

}  // namespace

int decks_command(const std::vector<std::string>& words, const std::string& into) {
  return guarded("tether decks", [&] {
    if (words.empty()) return list_decks();
    if (words.size() != 2 || words.front() != "get")
      throw InputError("'tether decks' lists the decks that come with the program, 'tether decks get NAME' copies one",
                       "tether decks get sod");
    get_deck(words.back(), into.empty() ? "." : into);
  });
}

int script_command(const std::string& command, const std::vector<std::string>& words) {
  return guarded("tether " + command, [&] { become_script(command + ".py", words); });
}

}  // namespace tether
