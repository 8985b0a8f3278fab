// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/study_remarks.hpp"

#include <algorithm>

namespace tether {
namespace {

/// An axis may have thousands of values on a line: it is not shown.
constexpr std::size_t longest_shown_line = 1000;

}  // namespace

void StudyRemarks::error(const std::string& name, int k, const std::string& message, const std::string& hint) {
  add(deck_.remark(Severity::error, group_, name, {k, 1}, message, hint));
}

void StudyRemarks::tell(const std::string& name, int k, const std::vector<Mistake>& mistakes) {
  const std::string text = deck_.text(group_, name, k);
  for (const auto& mistake : mistakes) {
    auto remark = deck_.remark(Severity::error, group_, name, {k, 1}, mistake.message, mistake.hint);
    const auto quote = static_cast<std::size_t>(remark.place.column);  // the text begins behind it
    const bool as_written = remark.line_text.compare(std::min(quote, remark.line_text.size()), text.size(), text) == 0;
    if (as_written) remark.place.column += mistake.column;
    add(std::move(remark));
  }
}

void StudyRemarks::add(Diagnostic remark) {
  if (remark.line_text.size() > longest_shown_line) remark.line_text.clear();
  diagnostics_.add(std::move(remark));
}

}  // namespace tether
