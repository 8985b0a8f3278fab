// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tether {

/// The folder with decks, particles and post that belongs to this program: share/tether next to the folder that it is
/// installed in, else the tree that it was built in. Throws FileError where there is neither.
std::filesystem::path shared_folder();

/// Replaces this process by a script of post/ with these words, so that the exit code is the script's. The interpreter
/// is /usr/bin/python3, for which Debian packages numpy and matplotlib, or what TETHER_PYTHON names. Throws FileError
/// where it cannot be started.
[[noreturn]] void become_script(const std::string& script, const std::vector<std::string>& words);

}  // namespace tether
