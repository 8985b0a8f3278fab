// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "deck/value.hpp"
#include "deck/variable.hpp"

namespace tether {

/// The table's default of a variable, without a place; nothing where it has none.
std::optional<DeckValue> default_value(const Variable& variable);

/// "an integer", "a number", ".true. or .false.", "a text in quotes".
std::string type_text(ValueType type);
/// The allowed values of a variable that has choices, one by one; empty for any.
std::vector<std::string> split_choices(const Variable& variable);
/// What values are allowed: "> 0", ">= 0", "2 to 1000000000", "0, 1 or 3"; empty for any.
std::string range_text(const Variable& variable);
/// "rix(20)", "xvi(20,20)", or the plain name of a scalar.
std::string shape_text(const Variable& variable);
/// The value as a deck writes it, so that it reads back bit by bit.
std::string value_text(const DeckValue& value);

}  // namespace tether
