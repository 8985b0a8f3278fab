// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "results/results.hpp"

namespace tether {

/// A text that grows while the program runs. What was appended is with the system at once, so it survives a crash; a
/// failed append leaves the file as it was before.
class TextFile {
 public:
  /// Creates the file, or empties the one that is there. Throws FileError.
  explicit TextFile(std::filesystem::path path);
  ~TextFile();
  TextFile(const TextFile&) = delete;
  TextFile& operator=(const TextFile&) = delete;

  /// Throws FileError with the system's reason.
  void append(std::string_view text);

 private:
  std::filesystem::path path_;
  int file_ = -1;
  std::size_t length_ = 0;  ///< bytes appended in full
};

/// Puts the text into the place of the file in one go: whoever reads sees the old text or the new one, never a part.
/// Throws FileError; the old text then stays.
void replace_file(const std::filesystem::path& path, std::string_view text);

/// summary.txt: the comments as `# ...` lines, then a line `key = value` for each pair. Throws FileError;
/// std::invalid_argument where a key or value could not be read back (a line end, a key that is empty or holds '=').
void write_summary(const std::filesystem::path& path, const Summary& summary, const std::vector<std::string>& comments);

/// reference.txt: a line `# names`, then a line of blank-separated numbers for each row, in digits that read back to
/// the same numbers. Throws FileError; std::invalid_argument where names and columns do not fit together.
void write_table(const std::filesystem::path& path, const Table& table);

}  // namespace tether
