// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/expression.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <muParser.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include "base/numbers.hpp"
#include "base/text.hpp"

namespace tether {
namespace {

using OfOne = double (*)(double);
using OfTwo = double (*)(double, double);

struct FunctionOfOne {
  const char* name;
  OfOne function;
};
struct FunctionOfTwo {
  const char* name;
  OfTwo function;
};
struct Constant {
  const char* name;
  double value;
};

double sign(double x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }
double smaller(double a, double b) { return std::fmin(a, b); }
double larger(double a, double b) { return std::fmax(a, b); }

constexpr std::array functions_of_one{
    FunctionOfOne{"sin", std::sin},     FunctionOfOne{"cos", std::cos},   FunctionOfOne{"tan", std::tan},
    FunctionOfOne{"asin", std::asin},   FunctionOfOne{"acos", std::acos}, FunctionOfOne{"atan", std::atan},
    FunctionOfOne{"sinh", std::sinh},   FunctionOfOne{"cosh", std::cosh}, FunctionOfOne{"tanh", std::tanh},
    FunctionOfOne{"exp", std::exp},     FunctionOfOne{"log", std::log},   FunctionOfOne{"log10", std::log10},
    FunctionOfOne{"sqrt", std::sqrt},   FunctionOfOne{"abs", std::fabs},  FunctionOfOne{"sign", sign},
    FunctionOfOne{"floor", std::floor},
};
constexpr std::array functions_of_two{FunctionOfTwo{"atan2", std::atan2}, FunctionOfTwo{"min", smaller},
                                      FunctionOfTwo{"max", larger}};
constexpr std::array constants{Constant{"pi", std::numbers::pi}, Constant{"e", std::numbers::e}};

constexpr std::size_t longest_text = 1000;  // a longer one is no formula that somebody wrote

std::vector<std::string> known_words() {
  std::vector<std::string> words;
  words.reserve(functions_of_one.size() + functions_of_two.size() + constants.size());
  for (const auto& function : functions_of_one) words.emplace_back(function.name);
  for (const auto& function : functions_of_two) words.emplace_back(function.name);
  for (const auto& constant : constants) words.emplace_back(constant.name);
  return words;
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

/// Returns the place after the number at `at`, with its exponent; `at` where there is none.
std::size_t behind_number(std::string_view text, std::size_t at) {
  const auto digits = [&](std::size_t k) {
    while (k < text.size() && is_digit(text[k])) ++k;
    return k;
  };
  if (!is_digit(text[at]) && (text[at] != '.' || at + 1 >= text.size() || !is_digit(text[at + 1]))) return at;
  std::size_t end = digits(at);
  if (end < text.size() && text[end] == '.') end = digits(end + 1);
  if (end >= text.size() || (text[end] != 'e' && text[end] != 'E')) return end;
  const std::size_t sign = end + 1 < text.size() && (text[end + 1] == '+' || text[end + 1] == '-') ? 1 : 0;
  const std::size_t behind = digits(end + 1 + sign);
  return behind > end + 1 + sign ? behind : end;
}

[[noreturn]] void refuse_word(const std::string& word, std::size_t at, const std::vector<std::string>& variables) {
  std::vector<std::string> words = variables;
  const auto known = known_words();
  words.insert(words.end(), known.begin(), known.end());
  const auto near = nearest_name(word, words, std::min<std::size_t>(word.size() - 1, 2));
  const auto in_lower = std::find(words.begin(), words.end(), lower(word));
  const auto& meant = in_lower != words.end() ? *in_lower : near;
  throw ExpressionError(fmt::format("the expression has an unknown word '{}'", word),
                        meant.empty()
                            ? fmt::format("It may have {}; {}.", fmt::join(variables, ", "), expression_words())
                            : fmt::format("Did you mean '{}'?", meant),
                        at);
}

/// Words, numbers and characters one by one, before the grammar: what muParser would take and a deck may not have
/// (assignments, strings, lists), and what it would blame at another place.
void check_pieces(const std::string& text, const std::vector<std::string>& variables) {
  const auto known = known_words();
  const auto is_known = [&](const std::string& word) {
    return std::find(known.begin(), known.end(), word) != known.end() ||
           std::find(variables.begin(), variables.end(), word) != variables.end();
  };
  for (std::size_t at = 0; at < text.size();) {
    if (const std::size_t behind = behind_number(text, at); behind > at) {
      at = behind;
    } else if (is_letter(text[at])) {
      std::size_t end = at;
      while (end < text.size() && (is_letter(text[end]) || is_digit(text[end]))) ++end;
      const std::string word = text.substr(at, end - at);
      if (!is_known(word)) refuse_word(word, at, variables);
      at = end;
    } else if (text[at] == '=' || std::string_view("<>!").find(text[at]) != std::string_view::npos) {
      const bool pair = at + 1 < text.size() && text[at + 1] == '=';
      if (!pair && (text[at] == '=' || text[at] == '!'))
        throw ExpressionError(fmt::format("'{}' is no operator of an expression", text[at]),
                              "Comparisons are <, <=, >, >=, == and !=; nothing is assigned.", at);
      at += pair ? 2 : 1;
    } else if (std::string_view(" \t+-*/^(),?:&|").find(text[at]) == std::string_view::npos) {
      throw ExpressionError(fmt::format("'{}' has no meaning in an expression",
                                        text[at] > ' ' && text[at] <= '~' ? text.substr(at, 1) : "?"),
                            "It is made of numbers, words, + - * / ^ ( ) and comparisons.", at);
    } else {
      ++at;
    }
  }
}

}  // namespace

std::string expression_words() {
  std::string functions;
  for (const auto& function : functions_of_one) functions += fmt::format("{}, ", function.name);
  for (const auto& function : functions_of_two) functions += fmt::format("{}(a,b), ", function.name);
  return functions + "pi, e";
}

bool is_expression_function(std::string_view name) {
  const auto named = [&](const auto& function) { return name == function.name; };
  return std::any_of(functions_of_one.begin(), functions_of_one.end(), named) ||
         std::any_of(functions_of_two.begin(), functions_of_two.end(), named);
}

struct Expression::Parser {
  std::string text;
  std::vector<std::string> names;
  std::vector<double> values;
  mu::Parser parser;

  Parser(std::string of, std::vector<std::string> variables)
      : text(std::move(of)), names(std::move(variables)), values(names.size(), 0.0) {
    parser.ClearFun();
    parser.ClearConst();
    for (const auto& [name, function] : functions_of_one) parser.DefineFun(name, function);
    for (const auto& [name, function] : functions_of_two) parser.DefineFun(name, function);
    for (const auto& [name, value] : constants) parser.DefineConst(name, value);
    for (std::size_t k = 0; k < names.size(); ++k) parser.DefineVar(names[k], &values[k]);
    parser.SetExpr(text);
  }
};

namespace {

/// The place of a mistake of the grammar; muParser's -1 stands for the end, and for a colon it gives the place after
/// it.
std::size_t place_of(const mu::ParserError& error, const std::string& text) {
  const auto at = static_cast<long long>(error.GetPos()) - (error.GetCode() == mu::ecMISPLACED_COLON ? 1 : 0);
  return at < 0 ? text.size() : std::min(static_cast<std::size_t>(at), text.size());
}

std::string without_full_stop(std::string message) {
  const auto at = message.find(" at position");
  if (at != std::string::npos) message.erase(at);
  const auto found = message.find(" found");
  if (found != std::string::npos && found + 6 == message.size()) message.erase(found);
  while (!message.empty() && (message.back() == '.' || message.back() == '!')) message.pop_back();
  if (!message.empty()) message[0] = lower(message.substr(0, 1))[0];
  return message;
}

}  // namespace

Expression::Expression(std::string text, std::vector<std::string> variables) {
  if (text.size() > longest_text)
    throw ExpressionError("the expression is too long", fmt::format("At most {} characters.", longest_text), 0);
  check_pieces(text, variables);
  parser_ = std::make_unique<Parser>(std::move(text), std::move(variables));
  try {
    parser_->parser.Eval();
  } catch (const mu::ParserError& error) {
    throw ExpressionError(fmt::format("the expression is wrong: {}", without_full_stop(error.GetMsg())),
                          "An expression is such as 'sin(2*pi*t)' or 't < 1 ? t : 1'.", place_of(error, parser_->text));
  }
  if (parser_->parser.GetNumResults() != 1)
    throw ExpressionError("the expression is wrong: it is a list", "A decimal point is '.', not ','.",
                          parser_->text.find(','));
}

Expression::Expression(Expression&&) noexcept = default;
Expression& Expression::operator=(Expression&&) noexcept = default;
Expression::~Expression() = default;

double Expression::operator()(std::span<const double> values) const {
  if (values.size() != parser_->values.size()) throw std::invalid_argument("an expression takes all its variables");
  std::copy(values.begin(), values.end(), parser_->values.begin());
  return parser_->parser.Eval();
}

const std::string& Expression::text() const { return parser_->text; }
const std::vector<std::string>& Expression::variables() const { return parser_->names; }

}  // namespace tether
