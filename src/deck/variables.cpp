// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/variables.hpp"

#include <algorithm>

namespace tether {
namespace {

std::vector<Variable> joined_table() {
  std::vector<Variable> table;
  for (const auto part :
       {in_variables(), fluid_variables(), region_variables(), membrane_variables(), added_variables(), fem_variables(),
        rigid_variables(), flow_variables(), coupled_variables(), study_variables(), published_variables()}) {
    table.insert(table.end(), part.begin(), part.end());
  }
  return table;
}

}  // namespace

std::span<const Variable> variables() {
  static const std::vector<Variable> table = joined_table();
  return table;
}

const Variable* find_variable(std::string_view group, std::string_view name) {
  const auto table = variables();
  const auto found = std::find_if(table.begin(), table.end(), [&](const Variable& variable) {
    return variable.name == name && variable.group == group;
  });
  return found == table.end() ? nullptr : &*found;
}

std::vector<std::string> group_names() {
  std::vector<std::string> names;
  for (const auto& variable : variables()) {
    if (names.empty() || names.back() != variable.group) names.emplace_back(variable.group);
  }
  return names;
}

bool chooses_path(std::string_view group) {
  return group == "fem" || group == "mesh" || group == "rigid" || group == "flow" || group == "coupled";
}

bool is_group(std::string_view name) {
  const auto table = variables();
  return std::any_of(table.begin(), table.end(), [&](const Variable& variable) { return variable.group == name; });
}

}  // namespace tether
