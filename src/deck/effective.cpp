// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "deck/document.hpp"
#include "deck/elements.hpp"
#include "deck/spelling.hpp"

namespace tether {
namespace {

/// Whether the defaults of regions 1..nreg are shown: where there are any, and they do not stand for "none".
bool shows_region_defaults(const Variable& variable) {
  return variable.rank == 1 && variable.n1 == region_count && !variable.fallback.empty() && variable.fallback != "1e30";
}

std::string assignment(const Deck& deck, const Variable& variable, Subscript at) {
  const auto value = deck.value(variable.group, variable.name, at[0], at[1]);
  return fmt::format("{} = {}\n", element_name(variable, at), value_text(value));
}

/// The elements that are given, and those of regions 1..nreg whose defaults are shown, in column-major order.
std::vector<Subscript> shown_elements(const Deck& deck, const Variable& variable) {
  auto shown = deck.given_elements(variable.group, variable.name);
  if (variable.rank == 0 && shown.empty() && !variable.fallback.empty()) shown.push_back({1, 1});
  if (!shows_region_defaults(variable)) return shown;
  for (int region = 1; region <= deck.integer("reg", "nreg"); ++region) {
    if (!deck.given(variable.group, variable.name, region)) shown.push_back({region, 1});
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

std::string effective_deck(const Deck& deck, const std::vector<std::string>& also) {
  std::string text;
  for (const auto& line : deck.header()) text += line + "\n";
  for (const auto& group : deck.possible_groups()) {
    if (group == published_group) continue;  // it says nothing to the run
    const bool silent = chooses_path(group) && !deck.has_group(group);
    if (silent && std::find(also.begin(), also.end(), group) == also.end()) continue;
    std::string items;
    for (const auto& variable : variables()) {
      if (variable.group == group) items += assignments(deck, variable);
    }
    if (!items.empty() || deck.has_group(group)) text += fmt::format("${}\n{}$\n", group, items);
  }
  return text + deck.trailer().text;
}

}  // namespace tether
