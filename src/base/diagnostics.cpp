// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/diagnostics.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <iterator>
#include <set>

#include "base/text.hpp"

namespace tether {
namespace {

std::string position(const Place& place) {
  if (place.file.empty()) return "";
  if (place.line <= 0) return fmt::format("{}: ", place.file);
  if (place.column <= 0) return fmt::format("{}:{}: ", place.file, place.line);
  return fmt::format("{}:{}:{}: ", place.file, place.line, place.column);
}

/// The line and a caret; tabs are kept before the caret so that it stands under its column in any terminal.
std::string excerpt(const Diagnostic& diagnostic) {
  constexpr std::size_t longest_line = 1000;
  if (diagnostic.line_text.empty() || diagnostic.line_text.size() > longest_line) return "";
  std::string caret;
  const auto before = static_cast<std::size_t>(std::max(diagnostic.place.column - 1, 0));
  for (std::size_t k = 0; k < before; ++k) {
    caret += k < diagnostic.line_text.size() && diagnostic.line_text[k] == '\t' ? '\t' : ' ';
  }
  return diagnostic.place.column > 0 ? fmt::format("  {}\n  {}^\n", diagnostic.line_text, caret)
                                     : fmt::format("  {}\n", diagnostic.line_text);
}

/// The text with a ? for each control character but tab and line end: one may steer a terminal, and what() of an error
/// would end at a zero byte.
std::string printable(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return (c < ' ' && c != '\t' && c != '\n') || c == 0x7f; }, '?');
  return text;
}

std::string all_text(const std::vector<Diagnostic>& diagnostics) {
  std::string text;
  for (const auto& diagnostic : diagnostics) text += to_text(diagnostic);
  return text;
}

std::vector<Diagnostic> placeless_error(const std::string& message, const std::string& hint) {
  Diagnostic diagnostic;
  diagnostic.message = message;
  diagnostic.hint = hint;
  return {diagnostic};
}

}  // namespace

std::string to_text(const Diagnostic& diagnostic) {
  const char* word = diagnostic.severity == Severity::error     ? "error"
                     : diagnostic.severity == Severity::warning ? "warning"
                                                                : "remark";
  std::string text = fmt::format("{}{}: {}\n", position(diagnostic.place), word, diagnostic.message);
  text = with_short_words(text) + excerpt(diagnostic);
  if (!diagnostic.hint.empty()) text += fmt::format("  {}\n", with_short_words(diagnostic.hint));
  return printable(text);
}

InputError::InputError(std::vector<Diagnostic> diagnostics)
    : std::runtime_error(all_text(diagnostics)), diagnostics_(std::move(diagnostics)) {}

InputError::InputError(const std::string& message, const std::string& hint)
    : InputError(placeless_error(message, hint)) {}

void Diagnostics::error(Place place, std::string line_text, std::string message, std::string hint) {
  add({Severity::error, std::move(place), std::move(line_text), std::move(message), std::move(hint)});
}

void Diagnostics::warn(Place place, std::string line_text, std::string message, std::string hint) {
  add({Severity::warning, std::move(place), std::move(line_text), std::move(message), std::move(hint)});
}

std::vector<Diagnostic> Diagnostics::select(Severity severity) const {
  std::vector<Diagnostic> chosen;
  std::copy_if(all_.begin(), all_.end(), std::back_inserter(chosen),
               [severity](const Diagnostic& diagnostic) { return diagnostic.severity == severity; });
  return chosen;
}

std::vector<Diagnostic> Diagnostics::remarks() const { return select(Severity::remark); }
std::vector<Diagnostic> Diagnostics::warnings() const { return select(Severity::warning); }
std::vector<Diagnostic> Diagnostics::errors() const { return select(Severity::error); }
bool Diagnostics::has_errors() const { return !errors().empty(); }

void Diagnostics::throw_if_errors() const {
  if (!has_errors()) return;
  std::vector<Diagnostic> told;
  std::set<std::string> texts;
  for (const Diagnostic& diagnostic : all_) {
    const bool tells = diagnostic.severity != Severity::remark && !diagnostic.moot;
    if (tells && texts.insert(to_text(diagnostic)).second) told.push_back(diagnostic);
  }
  throw InputError(std::move(told));
}

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
