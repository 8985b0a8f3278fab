// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"

namespace tether {

enum class TokenKind { opener, terminator, word, quoted, equals, open, close, colon, comma, end_of_text };

/// A piece of a group. Text: of an opener the group's name in lower case, of a word the word, of a quoted text what
/// stands between its quotes.
struct Token {
  TokenKind kind;
  std::string text;
  int line = 0, column = 0;  ///< from 1
  bool glued = false;        ///< a quoted text right after a '*', as in 3*'a'
};

/// A deck, cut into the lines above its groups, the groups' tokens, and what stands after them.
struct LexedDeck {
  std::vector<std::string> header;
  std::vector<Token> tokens;  ///< ends with end_of_text
  Trailer trailer;
};

/// Cuts a deck into tokens. A line that begins with $NAME or &NAME opens a group; '/', $end, &end, or a '$' or '&' with
/// nothing after it closes one. Semicolons are taken for commas, with a remark.
LexedDeck lex_deck(const std::vector<std::string>& lines, Remarks& remarks);

/// The tokens of lines[index], a text in which no group opens (an override of the command line).
std::vector<Token> lex_override(const std::vector<std::string>& lines, std::size_t index, Remarks& remarks);

}  // namespace tether
