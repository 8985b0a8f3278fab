// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace tether {

using RowNumbers = std::array<double, 7>;

/// Widths of a fused row, 2 fields of w1 characters and 5 of w2: (2Fw1, 5Fw2) as Fortran wrote it.
struct FusedLayout {
  std::size_t w1 = 0, w2 = 0;
};

/// The seven numbers of a row that blanks or commas part, else nothing.
std::optional<RowNumbers> list_row(std::string_view row);

/// The seven numbers of a fused row in a layout, where each field is one complete number with one '.', right-adjusted;
/// else nothing.
std::optional<RowNumbers> fused_row(std::string_view row, FusedLayout layout);

/// All layouts whose widths, 2 w1 + 5 w2, add up to a row's length, and in which it is seven numbers.
std::vector<FusedLayout> layouts_of(std::string_view row);

/// Whether a row could be a fused one: nothing but what numbers are written with.
bool looks_fused(std::string_view row);

}  // namespace tether
