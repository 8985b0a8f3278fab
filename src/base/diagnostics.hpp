// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "base/place.hpp"

namespace tether {

/// A remark is on what is known to do no harm, such as the slips of the decks that the thesis prints: it is written
/// down, but not reported in full next to warnings, which it would hide.
enum class Severity { remark, warning, error };

/// A note on what the user wrote: where, the line itself, what is wrong, what would be right.
struct Diagnostic {
  Severity severity = Severity::error;
  Place place;
  std::string line_text;  ///< the line as written, without its end; empty if the place names none
  std::string message;    ///< what is wrong
  std::string hint;       ///< what would be right, or empty
  bool moot = false;      ///< an error that only follows from another one, which was told: it counts, but is not told
};

/// `file:line:column: error: message`, the line, a caret under the column, the hint. Ends with a newline.
std::string to_text(const Diagnostic& diagnostic);

/// Every mistake of the user's input, found before anything was written: the program ends with exit code 2.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<Diagnostic> diagnostics);
  explicit InputError(const std::string& message, const std::string& hint = {});
  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

 private:
  std::vector<Diagnostic> diagnostics_;
};

/// Collects remarks so that all of them are told at once.
class Diagnostics {
 public:
  void add(Diagnostic diagnostic) { all_.push_back(std::move(diagnostic)); }
  void error(Place place, std::string line_text, std::string message, std::string hint = {});
  void warn(Place place, std::string line_text, std::string message, std::string hint = {});
  bool has_errors() const;
  const std::vector<Diagnostic>& all() const { return all_; }
  std::vector<Diagnostic> remarks() const;
  std::vector<Diagnostic> warnings() const;
  std::vector<Diagnostic> errors() const;
  /// Throws InputError with all errors and warnings, each once, when at least one is an error.
  void throw_if_errors() const;

 private:
  std::vector<Diagnostic> select(Severity severity) const;
  std::vector<Diagnostic> all_;
};

}  // namespace tether
