// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace tether {

/// What is wrong with an expression, what would be right, and at which of its bytes, from 0.
class ExpressionError : public std::runtime_error {
 public:
  ExpressionError(const std::string& message, std::string hint, std::size_t at)
      : std::runtime_error(message), hint_(std::move(hint)), at_(at) {}
  const std::string& hint() const { return hint_; }
  std::size_t at() const { return at_; }

 private:
  std::string hint_;
  std::size_t at_;
};

/// A formula in named variables, as a deck writes it: numbers, + - * / ^, comparisons, && and ||, a ? b : c, the
/// constants pi and e, and the functions that expression_words() lists. It means the same under every locale. Made by
/// muParser (Debian libmuparser). One object evaluates for one thread at a time; another thread takes an object of its
/// own, made from the same text.
class Expression {
 public:
  /// Throws ExpressionError where the text is no such formula. The names are letters; none is a function or a constant.
  Expression(std::string text, std::vector<std::string> variables);
  Expression(Expression&&) noexcept;
  Expression& operator=(Expression&&) noexcept;
  ~Expression();

  /// Its value, which may be infinite or no number. `values` are those of the variables, in their order (else
  /// std::invalid_argument).
  double operator()(std::span<const double> values) const;
  const std::string& text() const;
  const std::vector<std::string>& variables() const;

 private:
  struct Parser;  // muParser keeps the values of variables and its stack in itself
  std::unique_ptr<Parser> parser_;
};

/// The functions and constants, for messages and documents: "sin, cos, ...".
std::string expression_words();

/// Returns whether an expression may have a function of this name.
bool is_expression_function(std::string_view name);

}  // namespace tether
