// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/lexer.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.hpp"
#include "deck/opener.hpp"

namespace tether {
namespace {

bool ends_word(char c) { return !is_plain(c) || std::string_view(",;/=()!'\":$&").find(c) != std::string_view::npos; }

/// Returns whether this cannot follow a text in quotes: the text was closed too soon, or is not meant to be closed
/// there.
bool begins_value(char c) { return c == '\'' || c == '"' || !ends_word(c); }

class Lexer {
 public:
  Lexer(const std::vector<std::string>& lines, Remarks& remarks, std::size_t first, std::size_t end)
      : lines_(lines), remarks_(remarks), line_(first), end_(end) {}

  LexedDeck deck();
  std::vector<Token> override_tokens();

 private:
  const std::string& line() const { return lines_[line_]; }
  bool in_line() const { return line_ < end_ && column_ < line().size(); }
  char here() const { return line()[column_]; }
  int line_number() const { return static_cast<int>(line_) + 1; }
  int column_number() const { return static_cast<int>(column_) + 1; }
  void next_line() { ++line_, column_ = 0; }
  void push(TokenKind kind, std::string text = {}) {
    tokens_.push_back({kind, std::move(text), line_number(), column_number(), false});
  }
  void push_mark(TokenKind kind) { push(kind), ++column_; }

  void open_group(const Opener& opener);
  bool group_lines();
  bool rest_of_line();
  void pass_foreign_comment();
  bool piece();
  bool dollar();
  void word();
  void quoted_text();
  bool quoted_character(char quote, std::string& text);
  bool misclosed(const Token& token);
  std::string first_word_of(const Token& token);
  void odd_bytes();
  void semicolon();
  void behind_terminator();
  Trailer trailer(std::size_t first) const;

  const std::vector<std::string>& lines_;
  Remarks& remarks_;
  std::size_t line_, end_, column_ = 0;
  std::vector<Token> tokens_;
};

LexedDeck Lexer::deck() {
  LexedDeck result;
  std::size_t outside = 0;  // first line after the last group so far
  bool closed = false;
  while (line_ < end_) {
    const auto opener = opener_of(line());
    if (!opener) {
      tell_of_hidden_opener(line(), line_number(), 0, remarks_);
      if (tokens_.empty()) result.header.push_back(line());
      next_line();
      continue;
    }
    if (closed) tell_of_stray_lines(lines_, outside, line_, remarks_);
    open_group(*opener);
    closed = group_lines();
    outside = line_;
  }
  if (closed) result.trailer = trailer(outside);
  if (end_ > 0) line_ = end_ - 1, column_ = line().size();  // what ends too soon is reported after the last line
  push(TokenKind::end_of_text);
  result.tokens = std::move(tokens_);
  return result;
}

std::vector<Token> Lexer::override_tokens() {
  if (rest_of_line()) remarks_.error(line_number(), 1, "a group ends in this override", "Write texts in quotes.");
  push(TokenKind::end_of_text);
  return std::move(tokens_);
}

void Lexer::open_group(const Opener& opener) {
  column_ = opener.column;
  push(TokenKind::opener, opener.name);
  if (opener.detached) {
    remarks_.error(line_number(), column_number(), fmt::format("blanks before the group's name '{}'", opener.name),
                   fmt::format("Write '{}{}'.", here(), opener.name));
  }
  column_ = opener.end;
}

/// Up to the group's terminator (true), the next opener or the end of the text (false).
bool Lexer::group_lines() {
  while (line_ < end_) {
    const bool closed = rest_of_line();
    if (closed) behind_terminator();
    if (line_ < end_) next_line();
    if (closed) return true;
    if (line_ < end_ && opener_of(line())) return false;
  }
  return false;
}

/// True when the group's terminator was found.
bool Lexer::rest_of_line() {
  if (column_ == 0 && line_ < end_) pass_foreign_comment();
  while (in_line()) {
    if (piece()) return true;
  }
  return false;
}

/// A line that is a comment elsewhere is reported, and nothing of it read.
void Lexer::pass_foreign_comment() {
  const std::string_view mark = foreign_comment(line());
  if (mark.empty()) return;
  column_ = line().find_first_not_of(" \t");
  remarks_.error(line_number(), column_number(), fmt::format("{} begins no comment", in_quotes(mark)),
                 "A comment begins with '!'.");
  column_ = line().size();
}

/// The rest of a terminator's line is passed over; what was hardly meant so is reported.
void Lexer::behind_terminator() {
  const auto& end = tokens_.back();
  const bool glued = line()[column_ - 1] == '/' && in_line() && !is_blank(here()) && here() != '!';
  if (glued) {
    remarks_.warn(end.line, end.column, "'/' ends the group; what stands after it is not read",
                  "No value has a '/', and a comment begins with '!'.");
  }
  tell_of_hidden_opener(line(), line_number(), column_, remarks_);
}

/// One token, or what is none; true for a terminator.
bool Lexer::piece() {
  switch (const char c = here()) {
    case ' ':
    case '\t':
      ++column_;
      return false;
    case '!':
      column_ = line().size();
      return false;
    case '\'':
    case '"':
      quoted_text();
      return false;
    case '/':
      push_mark(TokenKind::terminator);
      return true;
    case '$':
    case '&':
      return dollar();
    case ';':
      semicolon();
      return false;
    case ',':
      push_mark(TokenKind::comma);
      return false;
    case '=':
      push_mark(TokenKind::equals);
      return false;
    case '(':
      push_mark(TokenKind::open);
      return false;
    case ')':
      push_mark(TokenKind::close);
      return false;
    case ':':
      push_mark(TokenKind::colon);
      return false;
    default:
      is_plain(c) ? word() : odd_bytes();
      return false;
  }
}

bool Lexer::dollar() {
  const auto rest = trim(std::string_view(line()).substr(column_ + 1));
  const bool alone = rest.empty() || rest[0] == '!';
  const bool named = lower(rest.substr(0, 3)) == "end" && ends_name(rest, 3);
  if (named && is_blank(line()[column_ + 1])) {
    remarks_.error(line_number(), column_number(), "blanks before 'end'", fmt::format("Write '{}end'.", here()));
  }
  if (alone || named) {
    push_mark(TokenKind::terminator);
    return true;
  }
  remarks_.error(line_number(), column_number(), fmt::format("'{}' inside a line of a group", here()),
                 "A group opens at the start of a line ($in); '$', '$end' or '/' closes it.");
  ++column_;
  while (in_line() && !ends_word(here())) ++column_;
  return false;
}

void Lexer::word() {
  const auto start = column_;
  auto stop = start;
  while (stop < line().size() && !ends_word(line()[stop])) ++stop;
  push(TokenKind::word, line().substr(start, stop - start));
  column_ = stop;
}

void Lexer::quoted_text() {
  push(TokenKind::quoted);
  tokens_.back().glued = column_ > 0 && line()[column_ - 1] == '*';
  const char quote = here();
  ++column_;
  std::string text;
  while (line_ < end_ && quoted_character(quote, text)) continue;
  if (misclosed(tokens_.back()) && line_number() > tokens_.back().line) text = first_word_of(tokens_.back());
  tokens_.back().text = std::move(text);
}

/// Goes one step within quotes; false after the closing quote. A text continues over the ends of lines, which it drops.
bool Lexer::quoted_character(char quote, std::string& text) {
  if (column_ >= line().size()) {
    next_line();
    return true;
  }
  const char c = here();
  const bool doubled = c == quote && column_ + 1 < line().size() && line()[column_ + 1] == quote;
  if (is_control(c)) {
    odd_bytes();
    return true;
  }
  column_ += doubled ? 2 : 1;
  if (c == quote && !doubled) return false;
  text += c;
  return true;
}

/// Reports a text that is not closed, or whose closing quote cannot be meant to be one.
bool Lexer::misclosed(const Token& token) {
  if (line_ == end_) {
    remarks_.error(token.line, token.column, "this quote is never closed", "End the text with the same quote.");
    return true;
  }
  if (!in_line() || !begins_value(here())) return false;
  remarks_.error(token.line, token.column, fmt::format("'{}' right after the quote that closes this text", here()),
                 "Is it closed where it should be? A quote inside a text is written twice: 'it''s'.");
  return true;
}

/// Goes back to where the text began: more than its first word may be what follows it in the deck.
std::string Lexer::first_word_of(const Token& token) {
  line_ = static_cast<std::size_t>(token.line) - 1;
  const auto start = static_cast<std::size_t>(token.column);
  column_ = std::min(line().find_first_of(" \t,;", start), line().size());
  return line().substr(start, column_ - start);
}

/// A run of bytes that are no plain text: one error, then they count as blanks.
void Lexer::odd_bytes() {
  constexpr std::size_t most_shown = 4;
  const auto start = column_;
  while (in_line() && !is_plain(here()) && !is_blank(here())) ++column_;
  std::string bytes;
  for (auto k = start; k < std::min(column_, start + most_shown); ++k)
    bytes += fmt::format(" 0x{:02X}", static_cast<unsigned char>(line()[k]));
  const bool nbsp = line().compare(start, 2, "\xc2\xa0") == 0;
  remarks_.error(line_number(), static_cast<int>(start) + 1,
                 fmt::format("the bytes{} are not plain text{}", bytes, nbsp ? " (a no-break space)" : ""),
                 nbsp ? "Write a plain blank." : "A group takes plain ASCII outside quotes.");
}

void Lexer::semicolon() {
  remarks_.remark(line_number(), column_number(), "';' is taken for a comma");
  push_mark(TokenKind::comma);
}

Trailer Lexer::trailer(std::size_t first) const {
  if (first >= end_) return {};
  Trailer result{static_cast<int>(first) + 1, ""};
  for (auto k = first; k < end_; ++k) result.text += lines_[k] + "\n";
  return result;
}

}  // namespace

LexedDeck lex_deck(const std::vector<std::string>& lines, Remarks& remarks) {
  return Lexer(lines, remarks, 0, lines.size()).deck();
}

std::vector<Token> lex_override(const std::vector<std::string>& lines, std::size_t index, Remarks& remarks) {
  return Lexer(lines, remarks, index, index + 1).override_tokens();
}

}  // namespace tether
