// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <string>

namespace tether {

/// An elastic law with its numbers.
template <class Law>
std::string law_text(const Law& law) {
  std::string text(Law::name);
  for (const auto& [name, value] : law.numbers()) text += fmt::format(", {} {:.4g}", name, value);
  return law.note().empty() ? text : fmt::format("{}, {}", text, law.note());
}

}  // namespace tether
