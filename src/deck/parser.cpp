// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/parser.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/numbers.hpp"
#include "deck/opener.hpp"
#include "deck/table.hpp"

namespace tether {
namespace {

using enum TokenKind;

std::string shown(const Token& token) {
  switch (token.kind) {
    case word:
      return in_quotes(token.text);
    case quoted:
      return "a text in quotes";
    case equals:
      return "'='";
    case open:
      return "'('";
    case close:
      return "')'";
    case colon:
      return "':'";
    case comma:
      return "','";
    default:
      return "the group's end";
  }
}

class Parser {
 public:
  Parser(const std::vector<Token>& tokens, Remarks& remarks) : tokens_(tokens), remarks_(remarks) {}

  std::vector<Group> groups();
  Item override_item();

 private:
  const Token& here() const { return tokens_[at_]; }
  bool is(TokenKind kind) const { return here().kind == kind; }
  bool at_end_of_group() const { return is(opener) || is(terminator) || is(end_of_text); }
  bool at_item() const;
  void error(const Token& token, std::string message, std::string hint = {}) {
    remarks_.error(token.line, token.column, std::move(message), std::move(hint));
  }

  Group group();
  void end_of_group(const Token& opened);
  void stray();
  void skip_to_item();
  Item item();
  bool subscripts(Item& item);
  bool section(Section& section);
  bool bound(std::optional<Bound>& bound);
  bool values(Item& item);
  void value(Item& item);
  void count(ItemValue& value, const Token& token, std::size_t star);

  const std::vector<Token>& tokens_;
  Remarks& remarks_;
  std::size_t at_ = 0;
};

std::vector<Group> Parser::groups() {
  std::vector<Group> result;
  while (is(opener)) result.push_back(group());
  return result;
}

Group Parser::group() {
  Group result;
  result.opener = here();
  ++at_;
  const bool known = is_group(result.opener.text);
  while (!at_end_of_group()) {
    if (!known || is(comma)) {
      ++at_;
    } else if (!at_item()) {
      stray();
    } else {
      result.items.push_back(item());
    }
  }
  if (known) end_of_group(result.opener);
  if (is(terminator)) ++at_;
  return result;
}

void Parser::end_of_group(const Token& opened) {
  if (is(end_of_text)) {
    error(opened, fmt::format("the group ${} is never closed", opened.text), "Close it with a line '$' or '/'.");
  } else if (is(opener)) {
    remarks_.warn(
        here().line, here().column,
        fmt::format("${} opens while ${} is still open; ${} ends here", here().text, opened.text, opened.text),
        fmt::format("Close ${} with a line '$'.", opened.text));
  }
}

/// name = or name( ; a value is never followed by either.
bool Parser::at_item() const {
  if (!is(word) || here().text[0] == '#') return false;
  const auto next = tokens_[at_ + 1].kind;
  return next == equals || (next == open && is_letter(here().text[0]));
}

void Parser::stray() {
  const auto& text = here().text;
  const bool comment = is(word) && (text[0] == '#' || text[0] == '*' || text == "c" || text == "C");
  const std::string hint = comment ? "A comment begins with '!'." : "An item is: name = value, value ...";
  error(here(), fmt::format("{} is neither a variable with its '=' nor a value", shown(here())), hint);
  skip_to_item();
}

void Parser::skip_to_item() {
  while (!at_end_of_group() && !at_item()) ++at_;
}

Item Parser::item() {
  Item result;
  result.name = here();
  ++at_;
  result.broken = is(open) && !subscripts(result);
  if (!result.broken && !is(equals)) {
    error(result.name, fmt::format("'=' is missing after {}", in_quotes(result.name.text)),
          "An item is: name = value.");
    result.broken = true;
  }
  if (!result.broken) ++at_;
  if (!result.broken && !values(result)) result.broken = true;
  if (result.broken) skip_to_item();
  return result;
}

bool Parser::subscripts(Item& item) {
  item.subscripted = true;
  do {
    ++at_;
    Section read;
    if (!section(read)) {
      error(here(), fmt::format("{} in the subscript of {}", shown(here()), in_quotes(item.name.text)),
            "A subscript is: i, or first:last, or first:last:step.");
      return false;
    }
    item.sections.push_back(read);
  } while (is(comma));
  ++at_;  // the ')' on which section() ends if not on a comma
  return true;
}

/// True when a whole section was read and a ',' or ')' follows.
bool Parser::section(Section& section) {
  section.line = here().line;
  section.column = here().column;
  if (!bound(section.first)) return false;
  if (is(colon)) {
    section.range = true;
    ++at_;
    if (!bound(section.last)) return false;
  }
  if (section.range && is(colon)) {
    ++at_;
    if (!bound(section.step) || !section.step) return false;
  }
  return (section.first || section.range) && (is(comma) || is(close));
}

/// An integer, or nothing where another token stands; false for a word that is none.
bool Parser::bound(std::optional<Bound>& bound) {
  if (!is(word)) return true;
  const auto value = parse_integer(here().text);
  if (!value) return false;
  bound = Bound{*value, here().line, here().column};
  ++at_;
  return true;
}

/// Up to the next item or the group's end. A comma that no value stands before makes a null value.
bool Parser::values(Item& item) {
  bool behind_value = false;
  while (!at_end_of_group() && !at_item()) {
    if (is(comma)) {
      if (!behind_value) item.values.emplace_back();
      behind_value = false;
      ++at_;
    } else if (is(quoted) || (is(word) && here().text[0] != '#')) {
      value(item);
      behind_value = true;
    } else {
      error(here(), fmt::format("{} among the values of {}", shown(here()), in_quotes(item.name.text)),
            is(word) ? "A comment begins with '!'." : "");
      ++at_;
      return false;
    }
  }
  return true;
}

void Parser::value(Item& item) {
  const Token& token = here();
  ++at_;
  ItemValue result;
  result.kind = token.kind == quoted ? ItemValue::Kind::quoted : ItemValue::Kind::word;
  result.text = token.text;
  result.line = token.line;
  result.column = result.count_column = token.column;
  const auto star = token.kind == word ? token.text.find('*') : std::string::npos;
  if (star != std::string::npos) count(result, token, star);
  if (result.count > 0) item.values.push_back(std::move(result));
}

/// Takes r* off the value; a bad count is reported and leaves 0.
void Parser::count(ItemValue& value, const Token& token, std::size_t star) {
  const auto digits = std::string_view(token.text).substr(0, star);
  const auto count = digits.empty() || digits.find_first_not_of("0123456789") != std::string_view::npos
                         ? std::nullopt
                         : parse_integer(digits);
  value.text = token.text.substr(star + 1);
  value.count = count.value_or(0);
  value.counted = true;
  value.column += static_cast<int>(star) + 1;
  if (value.count == 0 || value.text.find('*') != std::string::npos) {
    error(token, fmt::format("{} is no repeated value", in_quotes(token.text)),
          "Write count*value without blanks, the count a whole number above 0.");
    value.count = 0;
  } else if (value.text.empty()) {
    const bool text_follows = is(quoted) && here().glued;
    value.kind = text_follows ? ItemValue::Kind::quoted : ItemValue::Kind::null;
    if (text_follows) value.text = tokens_[at_++].text;
  }
}

Item Parser::override_item() {
  Item result;
  result.name = here();
  result.broken = !at_item();
  if (result.broken) {
    error(here(), "this is no override", "Write group.name=value, such as in.tmax=0.5.");
    return result;
  }
  result = item();
  if (!is(end_of_text) && !is(terminator)) {
    error(here(), "one override sets one variable", "Give --set once more for the next.");
    result.broken = true;
  }
  return result;
}

}  // namespace

std::vector<Group> parse_groups(const std::vector<Token>& tokens, Remarks& remarks) {
  return Parser(tokens, remarks).groups();
}

Item parse_override(const std::vector<Token>& tokens, Remarks& remarks) {
  return Parser(tokens, remarks).override_item();
}

}  // namespace tether
