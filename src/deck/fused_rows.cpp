// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/fused_rows.hpp"

#include <algorithm>

#include "base/numbers.hpp"

namespace tether {
namespace {

constexpr std::size_t longest_fused_row = 280;  // 7 fields of 40 characters
constexpr std::string_view separators = " \t,;";

/// A right-adjusted Fw.d field. The '.' is what tells where a field ends: it must be there, once.
std::optional<double> field_number(std::string_view field) {
  field.remove_prefix(std::min(field.find_first_not_of(' '), field.size()));
  if (std::count(field.begin(), field.end(), '.') != 1) return std::nullopt;
  return parse_real(field);
}

}  // namespace

std::optional<RowNumbers> list_row(std::string_view row) {
  RowNumbers numbers{};
  std::size_t count = 0;
  while (true) {
    const auto start = row.find_first_not_of(separators);
    if (start == std::string_view::npos) break;
    row.remove_prefix(start);
    const auto length = std::min(row.find_first_of(separators), row.size());
    const auto number = parse_real(row.substr(0, length));
    if (!number || count == numbers.size()) return std::nullopt;
    numbers[count++] = *number;
    row.remove_prefix(length);
  }
  return count == numbers.size() ? std::optional(numbers) : std::nullopt;
}

std::optional<RowNumbers> fused_row(std::string_view row, FusedLayout layout) {
  if (2 * layout.w1 + 5 * layout.w2 != row.size()) return std::nullopt;
  RowNumbers numbers{};
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const auto width = k < 2 ? layout.w1 : layout.w2;
    const auto number = field_number(row.substr(0, width));
    if (!number) return std::nullopt;
    numbers[k] = *number;
    row.remove_prefix(width);
  }
  return numbers;
}

std::vector<FusedLayout> layouts_of(std::string_view row) {
  std::vector<FusedLayout> layouts;
  for (std::size_t w2 = 2; 5 * w2 + 4 <= row.size() && row.size() <= longest_fused_row; ++w2) {
    const FusedLayout layout{(row.size() - 5 * w2) / 2, w2};
    if (fused_row(row, layout)) layouts.push_back(layout);
  }
  return layouts;
}

bool looks_fused(std::string_view row) {
  return row.size() <= longest_fused_row && row.find('.') != std::string_view::npos &&
         row.find_first_not_of(" 0123456789+-.eEdDqQ") == std::string_view::npos;
}

}  // namespace tether
