// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/meant.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/text.hpp"

namespace tether {
namespace {

/// Changes of a letter that still make a name of another.
constexpr std::size_t near_enough = 3;

/// More would drown the reader.
constexpr std::size_t most_shown = 40;

}  // namespace

std::string meant(const std::string& name, const std::vector<std::string>& known) {
  const auto near = nearest_name(name, known, near_enough);
  if (!near.empty()) return fmt::format("Did you mean '{}'?", near);
  const auto shown = std::min(known.size(), most_shown);
  const auto end = known.begin() + static_cast<std::ptrdiff_t>(shown);
  const std::string rest = shown < known.size() ? fmt::format(" and {} more", known.size() - shown) : "";
  return fmt::format("There are {}{}.", fmt::join(known.begin(), end, ", "), rest);
}

}  // namespace tether
