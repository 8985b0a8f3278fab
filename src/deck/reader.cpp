// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/reader.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <tuple>

#include "base/text.hpp"
#include "deck/assign.hpp"
#include "deck/elements.hpp"
#include "deck/lexer.hpp"
#include "deck/parser.hpp"

namespace tether {
namespace {

/// A study describes runs whose values stand in decks of their own.
void check_study(const Deck& deck, Diagnostics& diagnostics) {
  for (const auto& group : group_names()) {
    if (group == study_group || !deck.has_group(group)) continue;
    return diagnostics.add(
        deck.remark_on_group(Severity::error, study_group, fmt::format("${} stands beside ${}", study_group, group),
                             "A study deck for 'tether sweep' has no other group; it names decks to run."));
  }
}

/// Returns whether a region that nreg does not count has what makes one: then nreg is the likely mistake.
bool is_described(const Deck& deck, int region) {
  return deck.given("reg.densir", region) || deck.given("reg.xvi", 1, region) || deck.given("reg.yvi", 1, region);
}

/// Box 12 sets vrx(2), Box 9 gives five nvi: of one and two regions.
void check_regions_beyond_nreg(const Deck& deck, Diagnostics& diagnostics) {
  const int nreg = deck.integer("reg.nreg");
  for (const auto& variable : variables()) {
    if (variable.group != "reg" || variable.rank == 0) continue;
    const auto region = static_cast<std::size_t>(variable.rank - 1);  // the last subscript
    const auto elements = deck.given_elements(AnyVariable(variable));
    const auto beyond = std::find_if(elements.begin(), elements.end(), [&](auto at) { return at[region] > nreg; });
    if (beyond == elements.end()) continue;
    const Severity severity = is_described(deck, (*beyond)[region]) ? Severity::warning : Severity::remark;
    diagnostics.add(deck.remark(severity, AnyVariable(variable), *beyond,
                                fmt::format("{} is set but nreg = {}", element_name(variable, *beyond), nreg),
                                "Values of regions above nreg are not used."));
  }
}

/// Boxes 10 and 11 set rex(3) and, for rix(3), rix(2) once more.
void check_inner_ellipses(const Deck& deck, Diagnostics& diagnostics) {
  constexpr std::array<std::array<AnyVariable, 2>, 2> axes{{{"reg.rex", "reg.rix"}, {"reg.rey", "reg.riy"}}};
  for (const auto& [outer, inner] : axes) {
    if (deck.given_elements(inner).empty()) continue;
    for (const auto& at : deck.given_elements(outer)) {
      if (at[0] > deck.integer("reg.nreg") || deck.given(inner, at[0])) continue;
      diagnostics.add(deck.remark(Severity::warning, outer, at,
                                  fmt::format("{}({}) is set but {}({}) never is", outer, at[0], inner, at[0]),
                                  fmt::format("{}({}) is taken as 0.", inner, at[0])));
    }
  }
}

/// True if a coordinate of a region's vertex is given and outside lower .. upper of the grid.
bool is_outside(const Deck& deck, RealVariable coordinate, Subscript at, RealVariable lower, RealVariable upper) {
  if (!deck.given(coordinate, at[0], at[1]) || !deck.given(lower) || !deck.given(upper)) return false;
  const double value = deck.real(coordinate, at[0], at[1]);
  return value < deck.real(lower) || value > deck.real(upper);
}

void check_vertices(const Deck& deck, Diagnostics& diagnostics) {
  for (int region = 1; region <= deck.integer("reg.nreg"); ++region) {
    for (int vertex = 1; vertex <= deck.integer("reg.nvi", region); ++vertex) {
      const bool x = is_outside(deck, "reg.xvi", {vertex, region}, "in.xleft", "in.xright");
      const bool y = is_outside(deck, "reg.yvi", {vertex, region}, "in.ybot", "in.ytop");
      if (!x && !y) continue;
      diagnostics.add(deck.remark(Severity::warning, x ? AnyVariable("reg.xvi") : "reg.yvi", {vertex, region},
                                  fmt::format("vertex {} of region {} is outside the grid", vertex, region),
                                  "Only the part of the region inside the grid can hold points."));
      break;
    }
  }
}

/// Every box gives intervals to outputs that are off: one warning for all.
void check_outputs_off(const Deck& deck, Diagnostics& diagnostics) {
  std::string off;
  Subscript first{};
  for (const auto& at : deck.given_elements("in.tiout")) {
    if (deck.integer("in.iout", at[0]) != 0) continue;
    if (off.empty()) first = at;
    off += (off.empty() ? "" : ", ") + std::to_string(at[0]);
  }
  if (off.empty()) return;
  diagnostics.add(deck.remark(Severity::remark, "in.tiout", first,
                              fmt::format("tiout is set for outputs that are off (iout = 0): {}", off)));
}

void check_regrig(const Deck& deck, Diagnostics& diagnostics) {
  if (!deck.has_group("regrig") || deck.given("regrig.nregrig")) return;
  diagnostics.add(deck.remark(Severity::remark, "regrig.nregrig", {1, 1}, "$regrig is there without nregrig",
                              "nregrig is taken as 0."));
}

}  // namespace

void check_required(const Deck& deck, const std::set<std::string>& mentioned,
                    const std::map<std::string, Place>& left_empty, Diagnostics& diagnostics) {
  if (deck.is_study()) return;
  if (!deck.has_group("in")) {
    diagnostics.error({deck.file(), 0, 0}, "", "there is no group $in",
                      deck.has_group(published_group)
                          ? "This deck has published numbers alone: tether reproduce runs it."
                          : "A deck has at least: $in ... $");
    return;
  }
  std::string missing;
  int count = 0;
  for (const auto& variable : variables()) {
    if (!variable.required) continue;
    const std::string key = key_of(variable);
    if (mentioned.count(key) > 0) continue;
    if (const auto empty = left_empty.find(key); empty != left_empty.end()) {
      diagnostics.error(empty->second, deck.line_text(empty->second),
                        fmt::format("{} has no default: it needs a value", variable.name));
      continue;
    }
    missing += (count++ == 0 ? "" : ", ") + std::string(variable.name);
  }
  if (count == 0) return;
  diagnostics.add(deck.remark_on_group(
      Severity::error, "in", fmt::format("$in lacks {}, which {} no default", missing, count == 1 ? "has" : "have")));
}

void check_deck(const Deck& deck, Diagnostics& diagnostics) {
  if (deck.is_study()) return check_study(deck, diagnostics);
  check_regions_beyond_nreg(deck, diagnostics);
  check_inner_ellipses(deck, diagnostics);
  if (!deck.has_group("mesh")) check_vertices(deck, diagnostics);
  check_outputs_off(deck, diagnostics);
  check_regrig(deck, diagnostics);
}

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

/// Remarks in the order of the deck; after them those on the deck as a whole, then those on overrides.
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
  if (auto [message, hint] = no_text(text); !message.empty()) {  // of which nothing else is worth a report
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
  // Last, for what is missing may be so by a mistake that was reported, such as a group that ended too soon.
  check_required(deck, assigner.mentioned(), assigner.left_empty(), diagnostics);
  return deck;
}

}  // namespace tether
