// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "deck/document.hpp"
#include "deck/elements.hpp"
#include "deck/spelling.hpp"

namespace tether {
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
    const auto written = deck.value(variable.group, variable.name, at[0], at[1]);
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

std::string check_lines(const Deck& deck, const Variable& variable) {
  const auto elements = deck.given_elements(variable.group, variable.name);
  if (elements.empty()) return check_line(deck, variable, {1, 1}, false);
  std::string text;
  for (const auto& at : elements) text += check_line(deck, variable, at, true);
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

std::string check_listing(const Deck& deck) {
  std::string text;
  for (const auto& group : deck.possible_groups()) {
    text += fmt::format("${}{}\n", group, deck.has_group(group) ? "" : " (not in the deck)");
    for (const auto& variable : variables()) {
      if (variable.group == group) text += check_lines(deck, variable);
    }
  }
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

std::string variables_markdown() {
  std::string text;
  for (const auto& name : group_names()) {
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
