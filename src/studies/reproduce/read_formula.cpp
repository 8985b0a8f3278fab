// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/reproduce/read_formula.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cctype>
#include <memory>

#include "base/numbers.hpp"
#include "base/text.hpp"
#include "studies/history_value.hpp"
#include "studies/reproduce/point_readings.hpp"
#include "studies/reproduce/reading_functions.hpp"

namespace tether::published {
namespace {

bool begins_word(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool is_of_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// The byte after the word, or after the number with its exponent, that begins at `at`.
std::size_t after_word(std::string_view text, std::size_t at) {
  while (at < text.size() && (is_of_word(text[at]) || text[at] == '.')) ++at;
  return at;
}
std::size_t after_blanks(std::string_view text, std::size_t at) {
  while (at < text.size() && text[at] == ' ') ++at;
  return at;
}

/// The bracket that closes the one at `open`; the end where none does.
std::size_t closing(std::string_view text, std::size_t open) {
  std::size_t at = open, depth = 0;
  for (; at < text.size(); ++at) {
    if (text[at] == '(') ++depth;
    if (text[at] == ')' && --depth == 0) break;
  }
  return at;
}

/// A part of a text and the byte at which it begins.
struct Piece {
  std::string text;
  std::size_t begin;
};

/// Returns what stands between commas that no bracket holds.
std::vector<Piece> pieces_of(std::string_view text, std::size_t begin) {
  std::vector<Piece> pieces{{"", begin}};
  std::size_t depth = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '(') ++depth;
    if (text[at] == ')' && depth > 0) --depth;
    if (text[at] == ',' && depth == 0)
      pieces.push_back({"", begin + at + 1});
    else
      pieces.back().text += text[at];
  }
  return pieces;
}

std::vector<std::string> function_names() {
  std::vector<std::string> names;
  for (const ReadingFunction& function : reading_functions()) names.push_back(function.name);
  return names;
}

/// The argument of a piece, as its kind has it.
Argument argument_of(const Piece& piece, ArgumentKind kind, std::vector<Mistake>& mistakes) {
  const std::string word(trim(piece.text));
  if (kind == ArgumentKind::number || kind == ArgumentKind::of_each)
    return read_formula(piece.text, piece.begin, mistakes);
  const std::size_t blanks = after_blanks(piece.text, 0);
  const int column = static_cast<int>(piece.begin + blanks) + 1;
  const auto number = parse_integer(word);
  if (word.empty()) mistakes.push_back({column, "an argument is missing", ""});
  if (kind == ArgumentKind::snapshot && word != "first" && word != "last" && (!number || *number < 0))
    mistakes.push_back({column, fmt::format("'{}' is no snapshot", word), "It is first, last, or a number from 0."});
  const std::vector<std::string> solutions = scene_value_names();
  if (kind == ArgumentKind::solution && std::ranges::find(solutions, word) == solutions.end())
    mistakes.push_back({column, fmt::format("no scene has a number {}", word), meant(word, solutions)});
  return word;
}

/// Goes through a text once: words become names, functions calls, for which a variable as long as the call stands, so
/// that a mistake of the rest is at its own column.
class FormulaReader {
 public:
  FormulaReader(std::string text, std::size_t begin, std::vector<Mistake>& mistakes)
      : rest_(std::move(text)), begin_(begin), mistakes_(mistakes) {}

  std::shared_ptr<const Formula> read() {
    const std::size_t known = mistakes_.size();
    while (at_ < rest_.size()) read_piece();
    if (mistakes_.size() == known) make_expression();
    return std::make_shared<const Formula>(std::move(parts_));
  }

 private:
  void read_piece() {
    if (!begins_word(rest_[at_])) {
      at_ = is_of_word(rest_[at_]) ? after_word(rest_, at_) : at_ + 1;
      return;
    }
    const std::size_t end = after_word(rest_, at_), open = after_blanks(rest_, end);
    const std::string word = rest_.substr(at_, end - at_);
    if (open < rest_.size() && rest_[open] == '(') return read_function(word, open);
    auto& names = parts_.names;
    const bool is_new = word != "pi" && word != "e" && std::find(names.begin(), names.end(), word) == names.end();
    if (is_new) names.push_back(word);
    at_ = end;
  }

  void read_function(const std::string& word, std::size_t open) {
    const std::size_t close = closing(rest_, open);
    const auto inside = pieces_of(std::string_view(rest_).substr(open + 1, close - open - 1), begin_ + open + 1);
    const ReadingFunction* function = find_reading_function(word);
    const bool as_expression =
        is_expression_function(word) && (!function || inside.size() != function->arguments.size());
    if (close == rest_.size()) {
      note(open, "this bracket is not closed", "");
      at_ = close;
    } else if (as_expression) {
      at_ = open;
    } else if (function == nullptr) {
      note(at_, fmt::format("there is no function {}", word), meant(word, function_names()));
      at_ = open;
    } else {
      take_call(*function, inside);
      stand_for(close + 1);
    }
  }

  void take_call(const ReadingFunction& function, const std::vector<Piece>& inside) {
    Call call{&function, {}};
    if (inside.size() != function.arguments.size()) {
      note(at_, fmt::format("{} takes {} arguments, not {}", function.name, function.arguments.size(), inside.size()),
           function.meaning);
    } else {
      for (std::size_t k = 0; k < inside.size(); ++k)
        call.arguments.push_back(argument_of(inside[k], function.arguments[k], mistakes_));
    }
    parts_.calls.push_back(std::move(call));
  }

  /// A variable for the last call, from here to `end`.
  void stand_for(std::size_t end) {
    std::string variable = fmt::format("_{}", parts_.calls.size());
    variable.resize(end - at_, ' ');
    rest_.replace(at_, end - at_, variable);
    at_ = end;
  }

  void make_expression() {
    auto variables = parts_.names;
    for (std::size_t k = 1; k <= parts_.calls.size(); ++k) variables.push_back(fmt::format("_{}", k));
    try {
      parts_.expression = std::make_unique<const Expression>(rest_, variables);
    } catch (const ExpressionError& error) {
      note(error.at(), error.what(), error.hint());
    }
  }

  void note(std::size_t at, const std::string& message, const std::string& hint) {
    mistakes_.push_back({static_cast<int>(begin_ + at) + 1, message, hint});
  }

  Formula::Parts parts_;
  std::string rest_;
  std::size_t begin_, at_ = 0;
  std::vector<Mistake>& mistakes_;
};

}  // namespace

std::shared_ptr<const Formula> read_formula(const std::string& text, std::size_t begin,
                                            std::vector<Mistake>& mistakes) {
  return FormulaReader(text, begin, mistakes).read();
}

ReadReading read_reading(const std::string& text) {
  ReadReading read;
  const auto formula = read_formula(text, 0, read.mistakes);
  if (!read.mistakes.empty()) return read;
  read.reading = [formula](const RunFiles& run) { return formula->of_run(run); };
  read.of_deck = formula->of_deck();
  read.keys = formula->keys(), read.columns = formula->columns();
  return read;
}

}  // namespace tether::published
