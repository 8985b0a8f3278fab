// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/reproduce/reproduce.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "base/errors.hpp"
#include "results/text_file.hpp"
#include "studies/reproduce/problems.hpp"
#include "studies/reproduce/report.hpp"
#include "studies/sweep.hpp"

namespace tether {
namespace {

namespace fs = std::filesystem;
using namespace published;

/// Of a problem by one method. The run that it is compared with belongs to all of the method's runs.
MethodResult result_of(const std::vector<PlannedRun>& runs, const std::vector<RunEnd>& ends, std::size_t problem,
                       Role role, Role reference_role) {
  MethodResult result;
  fs::path reference;
  const auto note = [&result](const Ending& ending) {
    if (ending.exit_code != exit_done && result.failure.empty()) result.failure = ending.message;
    return ending.exit_code == exit_done;
  };
  for (std::size_t k = 0; k < runs.size(); ++k) {
    if (runs[k].problem == problem && runs[k].role == reference_role && note(ends[k].ending))
      reference = ends[k].folder;
  }
  for (std::size_t k = 0; k < runs.size(); ++k) {
    if (runs[k].problem != problem || runs[k].role != role) continue;
    ++result.runs;
    if (fs::exists(ends[k].folder / "deck.effective")) result.begun.emplace_back(ends[k].folder, reference);
    if (note(ends[k].ending)) result.files.emplace_back(ends[k].folder, reference);
  }
  return result;
}

std::vector<ReportRow> rows_of(const std::vector<Problem>& problems, const std::vector<PlannedRun>& runs,
                               const std::vector<RunEnd>& ends) {
  std::vector<ReportRow> rows;
  for (std::size_t k = 0; k < problems.size(); ++k) {
    const auto thesis = result_of(runs, ends, k, Role::thesis, Role::thesis_reference);
    const auto robust = result_of(runs, ends, k, Role::robust, Role::robust_reference);
    std::transform(problems[k].quantities.begin(), problems[k].quantities.end(), std::back_inserter(rows),
                   [&](const Quantity& quantity) { return report_row(problems[k], quantity, thesis, robust); });
  }
  return rows;
}

/// An hour's runs are not to be lost to a folder that is not there.
void refuse_lost_file(const fs::path& file) {
  if (file.empty()) return;
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  if (!fs::is_directory(folder))
    throw FileError(fmt::format("{}: there is no folder {}", file.string(), folder.string()));
  if (fs::is_directory(file)) throw FileError(fmt::format("{}: is a folder", file.string()));
}

}  // namespace

ReproduceResult reproduce(const std::vector<std::string>& names, const ReproduceOptions& options) {
  const auto problems = problems_named(names, options.decks);
  const auto runs = plan_runs(problems, options.out);
  refuse_lost_file(options.write);
  const auto ends = run_all(runs, options.jobs, options.command, options.progress);
  const auto rows = rows_of(problems, runs, ends);
  if (!options.write.empty()) replace_file(options.write, markdown_text(rows, problems, options.command));
  ReproduceResult result{terminal_text(rows), {}, 0};
  for (const RunEnd& end : ends) result.file_trouble += end.ending.exit_code == exit_file ? 1 : 0;
  for (const ReportRow& row : rows) {
    if (row.standing == Standing::differs)
      result.disagreed.push_back(fmt::format("{}, {}: {}", row.problem, row.quantity, row.verdict));
  }
  return result;
}

std::string list_published_runs(const std::vector<std::string>& names, const ReproduceOptions& options) {
  std::string text;
  for (const PlannedRun& run : plan_runs(problems_named(names, options.decks), options.out)) {
    text += list_runs(run.study, run.out);
  }
  return text;
}

}  // namespace tether
