// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "deck/variable.hpp"

namespace tether {

/// All rows, those of a group together, in the order in which decks and documents show them.
std::span<const Variable> variables();
/// The row of group.name (lower case), or null.
const Variable* find_variable(std::string_view group, std::string_view name);
/// All groups, in the order of the table.
std::vector<std::string> group_names();
bool is_group(std::string_view name);

/// Whether a group chooses the path of a deck by being there.
bool chooses_path(std::string_view group);

}  // namespace tether
