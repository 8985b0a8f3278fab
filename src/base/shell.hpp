// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace tether {

/// A word as a POSIX shell takes it for this very word, whatever is in it.
std::string shell_word(const std::string& word);

/// Words of a command, each as above, with blanks between them.
std::string shell_command(const std::vector<std::string>& words);

}  // namespace tether
