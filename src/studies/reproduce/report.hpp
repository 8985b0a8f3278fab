// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "studies/reproduce/runs.hpp"
#include "studies/reproduce/verdict.hpp"

namespace tether::published {

/// A row of the table as texts.
struct ReportRow {
  std::string problem, quantity, thesis, robust, published, theory, exact, verdict;
  Standing standing = Standing::reported;
};

/// A number in five digits; several runs' as `median +- standard deviation (runs that show it of all)`; "-" of none.
std::string value_text(const Measured& measured);

/// What the thesis prints, with its places, "or" between what contradicts itself; "-" where it prints nothing.
std::string published_text(const Quantity& quantity);

/// A quantity next to what both methods' runs show. A method that has no runs stands as "-" and is not judged.
ReportRow report_row(const Problem& problem, const Quantity& quantity, const MethodResult& thesis,
                     const MethodResult& robust);

/// The rows below each other, for a terminal, and how many agree, differ, are undecided and are reported.
std::string terminal_text(const std::vector<ReportRow>& rows);

/// The rows as a table in Markdown, and below it each problem's deck, where the thesis has it, and the overrides of
/// both methods.
std::string markdown_text(const std::vector<ReportRow>& rows, const std::vector<Problem>& problems,
                          const std::string& command);

}  // namespace tether::published
