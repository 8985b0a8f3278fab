// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/remarks.hpp"

#include <fmt/format.h>

#include "base/short_text.hpp"

namespace tether {
namespace {

constexpr int most_remarks = 100;
constexpr std::size_t longest_shown_line = 1000;
constexpr std::size_t longest_quoted_text = 60;

}  // namespace

void Remarks::error(int line, int column, std::string message, std::string hint) {
  add(Severity::error, errors_,
      {Severity::error, place(line, column), line_text(line), std::move(message), std::move(hint)});
}

void Remarks::remark(int line, int column, std::string message, std::string hint) {
  add(Severity::remark, warnings_,
      {Severity::remark, place(line, column), line_text(line), std::move(message), std::move(hint)});
}

void Remarks::warn(int line, int column, std::string message, std::string hint) {
  add(Severity::warning, warnings_,
      {Severity::warning, place(line, column), line_text(line), std::move(message), std::move(hint)});
}

void Remarks::add(Severity severity, int& count, Diagnostic diagnostic) {
  if (count > most_remarks) return;
  if (++count <= most_remarks) {
    diagnostics_.add(std::move(diagnostic));
    return;
  }
  const char* word = severity == Severity::error ? "errors" : "warnings";
  diagnostics_.add(
      {severity, place(0, 0), "", fmt::format("more than {} {}, no more are shown", most_remarks, word), ""});
}

std::string Remarks::line_text(int line) const {
  const auto index = static_cast<std::size_t>(line - first_line_);
  if (line < first_line_ || index >= lines_.size() || lines_[index].size() > longest_shown_line) return "";
  return lines_[index];
}

std::string in_quotes(std::string_view text) {
  std::string shown = shortened(text, longest_quoted_text);
  for (char& c : shown) {
    if (c < ' ' || c > '~') c = '?';
  }
  return fmt::format("'{}'", shown);
}

}  // namespace tether
