// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/remarks.hpp"

namespace tether {

// Text outside the groups of a deck says nothing. What was meant to is told.

/// Warns of text in lines[first] to lines[end - 1], which stand between two groups.
void tell_of_stray_lines(const std::vector<std::string>& lines, std::size_t first, std::size_t end, Remarks& remarks);

/// Warns where $NAME of a known group stands inside a line, from `from` on: there it opens no group.
void tell_of_hidden_opener(std::string_view line, int line_number, std::size_t from, Remarks& remarks);

}  // namespace tether
