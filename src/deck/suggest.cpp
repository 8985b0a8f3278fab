// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/suggest.hpp"

#include <fmt/format.h>

#include <vector>

#include "base/text.hpp"
#include "deck/variables.hpp"

namespace tether {
namespace {

constexpr std::size_t longest_name = 40;  // nothing in the table is near a longer one
constexpr std::size_t short_name = 3;     // two changes make any other word of it

std::size_t changes_allowed(const std::string& name) { return name.size() <= short_name ? 1 : 2; }

std::vector<std::string> names_of(const std::string& group) {
  std::vector<std::string> names;
  for (const auto& variable : variables()) {
    if (group.empty() || variable.group == group) names.emplace_back(variable.name);
  }
  return names;
}

std::string group_of(const std::string& name) {
  for (const auto& variable : variables()) {
    if (variable.name == name) return std::string(variable.group);
  }
  return "";
}

}  // namespace

std::string suggest_variable(const std::string& group, const std::string& name) {
  if (name.size() > longest_name) return "";
  const auto owner = group_of(name);
  if (!owner.empty()) return fmt::format("'{}' belongs to group ${}.", name, owner);
  auto near = nearest_name(name, names_of(group), changes_allowed(name));
  const auto home = near.empty() ? "" : group;
  if (near.empty()) near = nearest_name(name, names_of(""), changes_allowed(name));
  return near.empty() ? "" : fmt::format("Did you mean '{}' (group ${})?", near, home.empty() ? group_of(near) : home);
}

std::string suggest_group(const std::string& name) {
  const auto groups = group_names();
  const auto near = name.size() > longest_name ? "" : nearest_name(name, groups);
  if (!near.empty()) return fmt::format("Did you mean '${}'?", near);
  std::string all;
  for (const auto& group : groups) all += (all.empty() ? "$" : ", $") + group;
  return fmt::format("The groups are {}.", all);
}

}  // namespace tether
