// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.hpp"

namespace tether {

/// The opening of a group at the start of a line.
struct Opener {
  std::string name;        ///< lower case, known or not
  std::size_t column = 0;  ///< of the '$' or '&', from 0
  std::size_t end = 0;     ///< after the name
  bool detached = false;   ///< '& in': blanks before the name of a known group
};

/// Blanks, then $NAME or &NAME, NAME a word other than "end" that is followed by a separator, '!' or the line's end.
std::optional<Opener> opener_of(std::string_view line);

/// The mark by which a line is a comment in other languages ('#', '*', '//', fixed form's 'C'); empty where it is none.
std::string_view foreign_comment(std::string_view line);

bool is_blank(char c);  ///< blank or tab
bool is_letter(char c);
bool is_plain(char c);    ///< visible ASCII
bool is_control(char c);  ///< no tab; bytes above ASCII may stand in quotes (names of files in UTF-8)
bool ends_name(std::string_view line, std::size_t at);  ///< separator, '!' or the line's end at `at`

// Text outside the groups of a deck says nothing. What was meant to say something is reported.

/// Warns of text in lines[first] to lines[end - 1], which stand between two groups.
void tell_of_stray_lines(const std::vector<std::string>& lines, std::size_t first, std::size_t end, Remarks& remarks);

/// Warns where $NAME of a known group stands inside a line, from `from` on: there it opens no group.
void tell_of_hidden_opener(std::string_view line, int line_number, std::size_t from, Remarks& remarks);

}  // namespace tether
