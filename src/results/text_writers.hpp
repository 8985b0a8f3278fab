// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "results/results.hpp"

namespace tether {

/// summary.txt: the comments as `# ...` lines, then a line `key = value` for each pair. Throws FileError;
/// std::invalid_argument where a key or value could not be read back (a line end, a key that is empty or holds '=').
void write_summary(const std::filesystem::path& path, const Summary& summary, const std::vector<std::string>& comments);

/// reference.txt: a line `# names`, then a line of blank-separated numbers for each row, in digits that read back to
/// the same numbers. Throws FileError; std::invalid_argument where names and columns do not fit together.
void write_table(const std::filesystem::path& path, const Table& table);

}  // namespace tether
