// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/document.hpp"

#include <fmt/format.h>
#include <algorithm>

#include "deck/elements.hpp"
#include "deck/spelling.hpp"

namespace tether {
namespace {

/// Returns whether the defaults of regions 1..nreg are shown: where there are any, and they do not stand for "none".
bool shows_region_defaults(const Variable& variable) {
  return variable.rank == 1 && variable.n1 == region_count && !variable.fallback.empty() && variable.fallback != "1e30";
}

std::string assignment(const Deck& deck, const Variable& variable, Subscript at) {
  const auto value = deck.value(AnyVariable(variable), at[0], at[1]);
  return fmt::format("{} = {}\n", element_name(variable, at), value_text(value));
}

/// The elements that are given, and those of regions 1..nreg whose defaults are shown, in column-major order.
std::vector<Subscript> shown_elements(const Deck& deck, const Variable& variable) {
  auto shown = deck.given_elements(AnyVariable(variable));
  if (variable.rank == 0 && shown.empty() && !variable.fallback.empty()) shown.push_back({1, 1});
  if (!shows_region_defaults(variable)) return shown;
  for (int region = 1; region <= deck.integer("reg.nreg"); ++region) {
    if (!deck.given(AnyVariable(variable), region)) shown.push_back({region, 1});
  }
  std::sort(shown.begin(), shown.end());
  return shown;
}

std::string assignments(const Deck& deck, const Variable& variable) {
  std::string text;
  for (const auto& at : shown_elements(deck, variable)) text += assignment(deck, variable, at);
  return text;
}

}  // namespace

std::string effective_deck(const Deck& deck) {
  std::string text;
  for (const auto& line : deck.header()) text += line + "\n";
  for (const auto& group : deck.possible_groups()) {
    if (is_about_runs(group)) continue;  // it says nothing to the run
    if (acts_by_presence(group) && !deck.has_group(group)) continue;
    std::string items;
    for (const auto& variable : variables()) {
      if (variable.group == group) items += assignments(deck, variable);
    }
    if (!items.empty() || deck.has_group(group)) text += fmt::format("${}\n{}$\n", group, items);
  }
  return text + deck.trailer().text;
}

namespace {

constexpr std::string_view no_effect = "read, no effect";

std::string trimmed_right(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

/// One line of `tether check`; all elements of an array that is not given share one, as does what has no default.
std::string check_line(const Deck& deck, const Variable& variable, Subscript at, bool given) {
  const auto name = given ? element_name(variable, at) : shape_text(variable);
  const auto fallback = default_value(variable);
  std::string value = "-", origin = fallback ? "default" : "not given", place;
  if (given) {
    const auto written = deck.value(AnyVariable(variable), at[0], at[1]);
    value = value_text(written);
    origin = "given";
    const bool on_command_line = written.place.file == override_file;
    place = fmt::format("{}{}:{}", on_command_line ? "--set " : "", written.place.line, written.place.column);
  } else if (fallback) {
    value = value_text(*fallback);
  }
  return trimmed_right(fmt::format("  {:<20} {:<24} {:<10} {:<14} {:<14} {}", name, value, origin, variable.unit, place,
                                   variable.effect == Effect::none ? no_effect : ""));
}

/// Returns whether a given element says more than its default does.
bool differs(const Deck& deck, const Variable& variable, Subscript at) {
  const auto fallback = default_value(variable);
  return !fallback || value_text(deck.value(AnyVariable(variable), at[0], at[1])) != value_text(*fallback);
}

/// Name and value stand out; what has no effect is pale.
std::string coloured(const std::string& line, const Variable& variable) {
  constexpr std::size_t width = 46;  // of both
  const char* look = variable.effect == Effect::none ? "\033[2m" : "\033[1m";
  return fmt::format("{}{}\033[0m{}", look, line.substr(0, width), line.substr(std::min(width, line.size())));
}

/// Counts the variables, or elements of them, that it leaves out.
std::string check_lines(const Deck& deck, const Variable& variable, const CheckListing& how, int& left_out) {
  const auto elements = deck.given_elements(AnyVariable(variable));
  if (elements.empty()) {
    if (!how.all) return ++left_out, "";
    return check_line(deck, variable, {1, 1}, false);
  }
  std::string text;
  for (const auto& at : elements) {
    if (!how.all && !differs(deck, variable, at)) {
      ++left_out;
      continue;
    }
    const std::string line = check_line(deck, variable, at, true);
    text += how.colour ? coloured(line, variable) : line;
  }
  return text;
}

std::string type_word(ValueType type) {
  switch (type) {
    case ValueType::integer:
      return "integer";
    case ValueType::real:
      return "real";
    case ValueType::logical:
      return "logical";
    default:
      return "text";
  }
}

std::string fallback_text(const Variable& variable) {
  if (variable.required) return "required";
  return variable.fallback.empty() ? "-" : std::string(variable.fallback);
}

std::string listed_fallback(const Variable& variable) {
  if (variable.required) return "required";
  return variable.fallback.empty() ? "no default" : fmt::format("default {}", variable.fallback);
}

std::string meaning_text(const Variable& variable) {
  return fmt::format("{}{}", variable.meaning, variable.effect == Effect::none ? " (Read, no effect.)" : "");
}

std::string or_dash(std::string_view text) { return text.empty() ? "-" : std::string(text); }

}  // namespace

std::string check_listing(const Deck& deck, CheckListing how) {
  std::string text;
  int left_out = 0;
  for (const auto& group : deck.possible_groups()) {
    if (!how.all && is_about_runs(group)) continue;  // it says nothing to the run
    std::string lines;
    for (const auto& variable : variables()) {
      if (variable.group == group) lines += check_lines(deck, variable, how, left_out);
    }
    if (how.all || !lines.empty())
      text += fmt::format("${}{}\n{}", group, deck.has_group(group) ? "" : " (not in the deck)", lines);
  }
  if (left_out > 0)
    text += fmt::format("{} variables have their defaults, or are not given: --all lists them\n", left_out);
  return text;
}

std::string variables_listing(std::string_view group) {
  std::string text;
  for (const auto& name : group_names()) {
    if (!group.empty() && group != name) continue;
    text += fmt::format("${}\n", name);
    for (const auto& variable : variables()) {
      if (variable.group != name) continue;
      text += trimmed_right(fmt::format("  {:<20} {:<8} {:<13} {:<22} {:<18} {}", shape_text(variable),
                                        type_word(variable.type), or_dash(variable.unit), or_dash(range_text(variable)),
                                        listed_fallback(variable), meaning_text(variable)));
    }
  }
  return text;
}

std::string variables_markdown(const std::string& group) {
  std::string text;
  for (const auto& name : group_names()) {
    if (!group.empty() && name != group) continue;
    text +=
        fmt::format("{}## `${}`\n\n| name | type | unit | allowed | default | meaning |\n|---|---|---|---|---|---|\n",
                    text.empty() ? "" : "\n", name);
    for (const auto& variable : variables()) {
      if (variable.group != name) continue;
      text += fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", shape_text(variable), type_word(variable.type),
                          or_dash(variable.unit), or_dash(range_text(variable)), fallback_text(variable),
                          meaning_text(variable));
    }
  }
  return text;
}

}  // namespace tether
