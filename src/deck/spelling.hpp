// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "deck/table.hpp"

namespace tether {

/// The table's default of a variable, without a place; nothing where it has none.
std::optional<DeckValue> default_value(const Variable& variable);

/// "an integer", "a number", ".true. or .false.", "a text in quotes".
std::string type_text(ValueType type);
/// The allowed values of a variable that has choices, one by one; empty for any.
std::vector<std::string> split_choices(const Variable& variable);
/// Says what values are allowed: "> 0", ">= 0", "2 to 1000000000", "0, 1 or 3"; empty for any.
std::string range_text(const Variable& variable);
/// "rix(20)", "xvi(20,20)", or the plain name of a scalar.
std::string shape_text(const Variable& variable);
/// The value as a deck writes it, so that it reads back bit by bit.
std::string value_text(const DeckValue& value);

/// Guesses what a user may have meant by a variable that $group does not have: the group that has it, or the nearest
/// name (first of the same group); empty if nothing is near. Both in lower case.
std::string suggest_variable(const std::string& group, const std::string& name);

/// The variable "group.name" that such a suggestion means by another name; empty where there is none.
std::string meant_variable(const std::string& group, const std::string& name);

/// Guesses what a user may have meant by an unknown group: the nearest one, or else all of them.
std::string suggest_group(const std::string& name);

}  // namespace tether
