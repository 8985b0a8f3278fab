// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/properties.hpp"

#include <cstdio>

#include "deck/document.hpp"
#include "deck/reader.hpp"

namespace tether::fuzz {
namespace {

constexpr std::size_t most_listed = 10000;  // more values take longer to list than libFuzzer waits for one input

std::size_t value_count(const Deck& deck) {
  std::size_t count = 0;
  for (const auto& variable : variables()) count += deck.given_elements(variable.group, variable.name).size();
  return count;
}

}  // namespace

void expect(bool holds, const std::string& what) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", what.c_str());
  __builtin_trap();
}

void expect_places_inside(const Diagnostics& diagnostics, const std::vector<std::string>& lines) {
  for (const auto& diagnostic : diagnostics.all()) {
    const auto text = to_text(diagnostic);
    const auto& [file, line, column] = diagnostic.place;
    expect(!diagnostic.message.empty() && text.ends_with('\n'), "a remark says something");
    expect(line >= 0 && column >= 0 && static_cast<std::size_t>(line) <= lines.size(), "the line exists: " + text);
    if (line == 0) continue;
    const auto& written = lines[static_cast<std::size_t>(line) - 1];
    expect(static_cast<std::size_t>(column) <= written.size() + 1, "the column exists: " + text);
    expect(diagnostic.line_text.empty() || diagnostic.line_text == written, "the line is shown as written: " + text);
  }
}

void expect_survives(const Deck& deck) {
  if (value_count(deck) > most_listed) return;
  expect(!check_listing(deck).empty(), "a deck can be listed");
  const auto effective = effective_deck(deck);
  Diagnostics diagnostics;
  const Deck again = read_deck(effective, "deck.effective", {}, diagnostics);
  for (const auto& error : diagnostics.errors()) expect(false, "deck.effective reads: " + to_text(error) + effective);
  expect(effective_deck(again) == effective, "deck.effective says the same when read again:\n" + effective);
}

}  // namespace tether::fuzz
