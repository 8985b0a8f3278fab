// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/short_text.hpp"

#include <algorithm>

namespace tether {

std::string shortened(std::string_view text, std::size_t most) {
  constexpr std::string_view gap = "...";
  if (text.size() <= most || most < gap.size()) return std::string(text);
  const std::size_t kept = most - gap.size(), tail = kept / 2;
  return std::string(text.substr(0, kept - tail)).append(gap).append(text.substr(text.size() - tail));
}

std::string with_short_words(std::string_view text, std::size_t most) {
  std::string result;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of(" \t\r\n"), text.size());
    result += shortened(text.substr(0, end), most);
    if (end < text.size()) result += text[end];
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return result;
}

}  // namespace tether
