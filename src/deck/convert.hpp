// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "deck/elements.hpp"

namespace tether {

/// The value that a deck wrote for an element, of the variable's type, within its range and choices; what is not is
/// told, and nothing given.
std::optional<DeckValue> convert(const Variable& variable, Subscript at, const ItemValue& value, Remarks& remarks);

}  // namespace tether
