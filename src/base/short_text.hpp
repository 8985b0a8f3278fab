// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tether {

/// The text, with "..." in place of its middle where it is longer than `most` bytes.
std::string shortened(std::string_view text, std::size_t most);

/// The same of each of its words, which blanks and line ends part: names of files and of other things may be as long as
/// a user makes them.
std::string with_short_words(std::string_view text, std::size_t most = 300);

}  // namespace tether
