// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "base/expression.hpp"
#include "studies/reproduce/files.hpp"

namespace tether::published {

using Numbers = std::vector<double>;
class Formula;

/// What stands between the brackets of a function, as its kind has it: a word, or a formula.
using Argument = std::variant<std::string, std::shared_ptr<const Formula>>;

/// What an argument of a function is.
enum class ArgumentKind {
  word,      ///< a name: a field, a key, a value of the deck
  solution,  ///< a name of what follows from a scene by an exact solution
  column,    ///< a column of the history
  number,    ///< a formula of keys and functions
  of_each,   ///< a formula of the fields of points or nodes
  snapshot,  ///< first, last, or a number from 0
};

/// A function that a reading may have.
struct ReadingFunction {
  std::string name;
  std::vector<ArgumentKind> arguments;
  bool of_deck;         ///< it needs the deck that ran and nothing else
  std::string meaning;  ///< for the guide, a sentence
  double (*value)(const RunFiles& run, const std::vector<Argument>& arguments);
};

/// A function of a reading with its arguments.
struct Call {
  const ReadingFunction* function = nullptr;
  std::vector<Argument> arguments;
};

/// An expression of names and of functions of a finished run. Its names are keys of summary.txt, or fields of points or
/// nodes: whoever evaluates it says which. Where a function does not find what it reads, it throws FileError.
class Formula {
 public:
  struct Parts {
    std::vector<std::string> names;
    std::vector<Call> calls;                       ///< their values are the expression's variables after the names
    std::unique_ptr<const Expression> expression;  ///< null where the text is a mistake: it must not be evaluated
  };
  explicit Formula(Parts parts);

  const std::vector<std::string>& names() const { return parts_.names; }
  /// Keys of summary.txt that its value is made from, and columns of history.txt, in its own text and in that of what
  /// its functions take.
  std::vector<std::string> keys() const;
  std::vector<std::string> columns() const;
  /// Returns whether the deck that ran is all that it needs: it has no names, and no function of what the run wrote.
  bool of_deck() const { return of_deck_; }

  /// Its value, the names being keys of summary.txt.
  double of_run(const RunFiles& run) const;
  /// Its values at `count` points or nodes; the names are these fields, in their order.
  Numbers of_each(const RunFiles& run, const std::vector<Numbers>& fields, std::size_t count) const;

 private:
  Numbers of_calls(const RunFiles& run) const;

  Parts parts_;
  bool of_deck_ = true;
};

}  // namespace tether::published
