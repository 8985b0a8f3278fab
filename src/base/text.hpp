// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tether {

std::string lower(std::string_view text);                     ///< ASCII letters in lower case
std::string_view trim(std::string_view text);                 ///< without blanks, tabs and line ends on both sides
std::vector<std::string> split_lines(std::string_view text);  ///< at LF, CRLF or CR; no empty last line
std::vector<std::string> split_words(std::string_view text);  ///< at blanks and line ends

/// Number of single-letter changes between two words (insert, delete, replace).
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The candidate at the smallest edit distance (the first of equals), or empty where none is within `most`.
std::string nearest_name(std::string_view name, const std::vector<std::string>& candidates, std::size_t most = 2);

/// Lower-case hexadecimal SHA-256 of the bytes.
std::string sha256(std::string_view bytes);

/// The text, with "..." in place of its middle where it is longer than `most` bytes.
std::string shortened(std::string_view text, std::size_t most);

/// Does the same for each of its words, which blanks and line ends part: names of files and of other things may be as
/// long as a user makes them.
std::string with_short_words(std::string_view text, std::size_t most = 300);

/// Why bytes are no text that could be read: "the file is empty", "this is a NetCDF file" ...; and what would be right.
struct NoText {
  std::string message, hint;
};

/// Empty for a text, with or without odd bytes in it.
NoText no_text(std::string_view bytes);

}  // namespace tether
