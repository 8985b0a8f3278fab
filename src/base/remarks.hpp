// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.hpp"

namespace tether {

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
