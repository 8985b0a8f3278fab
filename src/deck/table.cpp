// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tether {
AnyVariable::AnyVariable(std::string_view group, std::string_view name) : row_(find_variable(group, name)) {
  if (row_ == nullptr) throw std::logic_error(fmt::format("the table has no variable {}.{}", group, name));
}

AnyVariable AnyVariable::with(std::string_view ending) const { return {group(), fmt::format("{}{}", name(), ending)}; }

std::string key_of(const Variable& variable) {
  std::string key(variable.group);
  key += '.';
  return key += variable.name;
}

std::vector<std::string> group_names() {
  std::vector<std::string> names;
  for (const auto& variable : variables()) {
    if (names.empty() || names.back() != variable.group) names.emplace_back(variable.group);
  }
  return names;
}

bool acts_by_presence(std::string_view group) {
  return group == "fem" || group == "mesh" || group == "contact" || group == "rigid" || group == "flow" ||
         group == "coupled";
}

bool is_group(std::string_view name) {
  const auto table = variables();
  return std::any_of(table.begin(), table.end(), [&](const Variable& variable) { return variable.group == name; });
}

}  // namespace tether
