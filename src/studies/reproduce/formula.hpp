// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "base/expression.hpp"
#include "studies/assignment.hpp"
#include "studies/reproduce/files.hpp"

namespace tether::published {

using Numbers = std::vector<double>;
struct ReadingFunction;
class Formula;

/// What stands between the brackets of a function, as its kind has it: a word, or a formula.
using Argument = std::variant<std::string, std::shared_ptr<const Formula>>;

/// A function of a reading with its arguments.
struct Call {
  const ReadingFunction* function = nullptr;
  std::vector<Argument> arguments;
};

/// An expression of names and of functions of a finished run. Its names are keys of summary.txt, or fields of points or
/// nodes: whoever evaluates it says which. Where a function does not find what it reads, it throws FileError.
class Formula {
 public:
  /// Notes mistakes at their columns of the whole text, in which this formula begins at byte `begin`; a formula with a
  /// mistake must not be evaluated.
  Formula(const std::string& text, std::size_t begin, std::vector<Mistake>& mistakes);

  const std::vector<std::string>& names() const { return names_; }
  /// Whether the deck that ran is all that it needs: it has no names, and no function of what the run wrote.
  bool of_deck() const { return of_deck_; }

  /// Its value, the names being keys of summary.txt.
  double of_run(const RunFiles& run) const;
  /// Its values at `count` points or nodes; the names are these fields, in their order.
  Numbers of_each(const RunFiles& run, const std::vector<Numbers>& fields, std::size_t count) const;

 private:
  friend class FormulaReader;
  Numbers of_calls(const RunFiles& run) const;

  std::vector<std::string> names_;
  std::vector<Call> calls_;                       // their values are variables after the names
  std::unique_ptr<const Expression> expression_;  // null where the text is a mistake
  bool of_deck_ = true;
};

}  // namespace tether::published
