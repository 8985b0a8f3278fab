// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/reader.hpp"

#include <algorithm>
#include <tuple>

#include "base/text.hpp"
#include "base/text_kind.hpp"
#include "deck/assign.hpp"
#include "deck/checks.hpp"
#include "deck/lexer.hpp"
#include "deck/parser.hpp"

namespace tether {
namespace {

std::string_view without_byte_order_mark(std::string_view text) {
  constexpr std::string_view mark = "\xef\xbb\xbf";
  if (text.starts_with(mark)) text.remove_prefix(mark.size());
  return text;
}

void read_overrides(const std::vector<std::string>& overrides, Assigner& assigner, Diagnostics& diagnostics) {
  Remarks remarks(std::string(override_file), overrides, 1, diagnostics);
  for (std::size_t k = 0; k < overrides.size(); ++k) {
    assigner.assign_override(parse_override(lex_override(overrides, k, remarks), remarks), remarks);
  }
}

/// Remarks in the order of the deck; behind them those on the deck as a whole, then those on overrides.
void add_in_order(const Diagnostics& found, Diagnostics& diagnostics) {
  auto all = found.all();
  std::stable_sort(all.begin(), all.end(), [](const Diagnostic& a, const Diagnostic& b) {
    const auto key = [](const Place& place) {
      return std::tuple(place.file == override_file, place.line == 0, place.line, place.column);
    };
    return key(a.place) < key(b.place);
  });
  for (auto& diagnostic : all) diagnostics.add(std::move(diagnostic));
}

}  // namespace

Deck read_deck(std::string_view text, const std::string& file, const std::vector<std::string>& overrides,
               Diagnostics& diagnostics) {
  Deck::Contents contents;
  contents.file = file;
  if (auto [message, hint] = no_text(text); !message.empty()) {  // of which nothing else is worth to be told
    diagnostics.error({file, 0, 0}, "", std::move(message),
                      hint.empty() ? "A deck has at least: $in ... $" : std::move(hint));
    return Deck(std::move(contents));
  }
  contents.text = text;
  contents.lines = split_lines(without_byte_order_mark(text));
  contents.overrides = overrides;

  Diagnostics found;
  Remarks remarks(file, contents.lines, 1, found);
  auto lexed = lex_deck(contents.lines, remarks);
  contents.header = std::move(lexed.header);
  contents.trailer = std::move(lexed.trailer);

  Assigner assigner(contents);
  assigner.assign(parse_groups(lexed.tokens, remarks), remarks);
  read_overrides(overrides, assigner, found);

  Deck deck(std::move(contents));
  check_deck(deck, found);
  add_in_order(found, diagnostics);
  // Last, for what is missing may be so by a mistake that was told of, such as a group that ended too soon.
  check_required(deck, assigner.mentioned(), assigner.left_empty(), diagnostics);
  return deck;
}

}  // namespace tether
