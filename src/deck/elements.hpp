// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "deck/parser.hpp"
#include "deck/table.hpp"

namespace tether {

/// The elements that an item's values fill one after the other, in column-major order: those of a section (the whole
/// array is one too), or all from one element on to the array's end.
struct Elements {
  std::array<long long, 2> first{1, 1}, step{1, 1};
  std::array<long long, 2> counts{1, 1};
  long long skipped = 0;  ///< elements before the one that the values begin with

  long long count() const { return counts[0] * counts[1] - skipped; }
  Subscript at(long long k) const;  ///< the k-th, from 0; k < count()
};

/// "nx", "rix(2)", "xvi(1,2)".
std::string element_name(const Variable& variable, Subscript at);

/// Which elements an item fills; a wrong subscript is reported and gives nothing.
std::optional<Elements> resolve_elements(const Variable& variable, const Item& item, Remarks& remarks);

/// The value that a deck wrote for an element, of the variable's type, within its range and choices; what is not is
/// reported, and nothing given.
std::optional<DeckValue> convert(const Variable& variable, Subscript at, const ItemValue& value, Remarks& remarks);

}  // namespace tether
