// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "base/failure.hpp"

namespace tether {

/// A place in a text the user wrote. Lines and columns count from 1 (columns in bytes); line 0 means the whole file,
/// column 0 the whole line.
struct Place {
  std::string file;
  int line = 0;
  int column = 0;
};

/// A run that diverged or lost a point; the text names point, cell, time and likely cause. Exit code 3.
class RunError : public std::runtime_error {
 public:
  explicit RunError(const std::string& text, Failure failure = Failure::diverges)
      : std::runtime_error(text), failure_(failure) {}
  Failure failure() const { return failure_; }

 private:
  Failure failure_;
};

/// A file that could not be read or written; the text names it and the system's reason. Exit code 4.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A run that a signal stopped; the text says at what time, and how to go on. Exit code 128 + signal.
class Interrupted : public std::runtime_error {
 public:
  Interrupted(int signal, const std::string& text) : std::runtime_error(text), signal_(signal) {}
  int signal() const { return signal_; }

 private:
  int signal_;
};

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
  bool moot = false;      ///< an error that only follows from a reported one: it counts, but is not reported
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

/// Collects remarks so that all of them are reported at once.
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

/// Makes remarks on the lines of one text. A text that is no deck at all would drown its reader: after 100 errors, and
/// after 100 warnings, the rest is only counted as "more".
class Remarks {
 public:
  /// `first_line` is the number of lines[0] in `file`. The references must outlive this.
  Remarks(std::string file, const std::vector<std::string>& lines, int first_line, Diagnostics& diagnostics)
      : file_(std::move(file)), lines_(lines), first_line_(first_line), diagnostics_(diagnostics) {}

  /// Lines and columns count from 1, lines by the file's numbering.
  void error(int line, int column, std::string message, std::string hint = {});
  void remark(int line, int column, std::string message, std::string hint = {});
  void warn(int line, int column, std::string message, std::string hint = {});
  bool has_errors() const { return errors_ > 0; }
  int errors() const { return errors_; }
  Place place(int line, int column) const { return {file_, line, column}; }

 private:
  void add(Severity severity, int& count, Diagnostic diagnostic);
  std::string line_text(int line) const;

  std::string file_;
  const std::vector<std::string>& lines_;
  int first_line_;
  Diagnostics& diagnostics_;
  int errors_ = 0, warnings_ = 0;
};

/// The text between quotes for a message, cut to a readable length, odd bytes shown as '?'.
std::string in_quotes(std::string_view text);

}  // namespace tether
