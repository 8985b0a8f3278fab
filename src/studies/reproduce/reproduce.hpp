// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "studies/reproduce/runs.hpp"
#include "studies/reproduce/verdict.hpp"
#include "studies/runs/scheduler.hpp"

namespace tether::published {

/// A row of the table as texts.
struct ReportRow {
  std::string problem, quantity, thesis, robust, published, theory, exact, verdict;
  Standing standing = Standing::reported;
};

/// A number in five digits; several runs' as `median +- standard deviation (runs that show it of all)`; "-" of none.
std::string value_text(const Measured& measured);

/// Says what the thesis prints, with its places, "or" between what contradicts itself; "-" where it prints nothing.
std::string published_text(const PublishedQuantity& quantity);

/// A quantity next to what both methods' runs show. A method that has no runs stands as "-" and is not judged.
ReportRow report_row(const Problem& problem, const PublishedQuantity& quantity, const MethodResult& thesis,
                     const MethodResult& robust);

/// The rows below each other, for a terminal, and how many agree, differ, are undecided and are reported.
std::string terminal_text(const std::vector<ReportRow>& rows);

/// The rows as a table in Markdown, and below it each problem's deck, where the thesis has it, and the overrides of
/// both methods.
std::string markdown_text(const std::vector<ReportRow>& rows, const std::vector<Problem>& problems,
                          const std::string& command);

}  // namespace tether::published

namespace tether {

/// How the published problems are to be run.
struct ReproduceOptions {
  std::filesystem::path decks = "decks";  ///< folder of their decks
  std::filesystem::path write;            ///< file for the table in Markdown; empty for none
  StudyOptions study;
};

/// What there is to say at the end.
struct ReproduceResult {
  std::string report;                  ///< the table, for a terminal, and why runs failed
  std::vector<std::string> disagreed;  ///< "problem, quantity: verdict" of what is judged and does not agree
  std::size_t file_trouble = 0;        ///< runs that could not read or write a file
  std::size_t unfinished = 0;          ///< runs that were to be collected and are not finished
};

/// Runs the published problems of these names (none: all), by the thesis' method and by the robust one, and sets what
/// the runs show next to what is published and what is exact. Throws InputError for names that there are not and
/// decks that cannot be understood, FileError, Interrupted.
ReproduceResult reproduce(const std::vector<std::string>& names, const ReproduceOptions& options);

/// Returns its runs, and bisections, as studies of their own. Throws InputError as above.
std::vector<StudyRun> published_runs(const std::vector<std::string>& names, const ReproduceOptions& options);

}  // namespace tether
