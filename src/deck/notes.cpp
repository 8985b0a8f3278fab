// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/notes.hpp"

#include <fmt/format.h>

#include "base/text.hpp"
#include "deck/opener.hpp"
#include "deck/variables.hpp"

namespace tether {

void tell_of_stray_lines(const std::vector<std::string>& lines, std::size_t first, std::size_t end, Remarks& remarks) {
  for (auto k = first; k < end; ++k) {
    const auto content = trim(lines[k]);
    if (content.empty() || content[0] == '!') continue;
    remarks.warn(static_cast<int>(k) + 1, 1, "text between two groups is ignored");
    return;
  }
}

void tell_of_hidden_opener(std::string_view line, int line_number, std::size_t from, Remarks& remarks) {
  line = line.substr(0, line.find('!'));
  for (auto at = line.find_first_of("$&", from); at < line.size(); at = line.find_first_of("$&", at + 1)) {
    const auto opener = opener_of(line.substr(at));
    if (!opener || opener->detached || !is_group(opener->name)) continue;
    remarks.warn(line_number, static_cast<int>(at) + 1, fmt::format("'${}' inside a line opens no group", opener->name),
                 "A group opens at the start of a line.");
    return;
  }
}

}  // namespace tether
