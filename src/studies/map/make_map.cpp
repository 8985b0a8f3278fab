// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/map/make_map.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/diagnostics.hpp"
#include "base/file.hpp"
#include "results/text_file.hpp"
#include "studies/reproduce/files.hpp"
#include "studies/run_table.hpp"

namespace tether::map {
namespace {

/// Reads off a run what theory says; a run that failed or does not show it has none.
double theory_of(const Map& map, const FinishedRun& run, const std::filesystem::path& out) {
  return run.failed() ? NAN : number_or_none(map.theory, published::RunFiles(run_folder(out, run.record.key)));
}

/// Finds the rows of squares by what was run: their combinations become rows of the runs.
std::vector<std::optional<std::size_t>> rows_of(const std::vector<std::optional<std::size_t>>& deciding,
                                                const std::vector<FinishedRun>& runs) {
  std::map<std::size_t, std::size_t> row;
  for (std::size_t k = 0; k < runs.size(); ++k) row[runs[k].variant.combination] = k;
  std::vector<std::optional<std::size_t>> rows;
  for (const auto& by : deciding) rows.push_back(by ? std::optional(row.at(*by)) : std::nullopt);
  return rows;
}

/// Keeps what squares have of runs of their own: of a map that was stopped nothing follows for the other squares.
void keep_own(const std::vector<FinishedRun>& runs, std::vector<std::optional<std::size_t>>& decided_by) {
  for (std::size_t k = 0; k < decided_by.size(); ++k) {
    if (decided_by[k] && runs[*decided_by[k]].variant.combination != k) decided_by[k].reset();
  }
}

std::size_t count_telling_nothing(const Outcome& outcome) {
  const auto runs = std::count(outcome.verdicts.begin(), outcome.verdicts.end(), "tells nothing");
  const auto lost = std::count_if(outcome.bisections.begin(), outcome.bisections.end(), [](const Bisection& bisection) {
    return !bisection.found() && !bisection.verdict().starts_with("both ends");
  });
  return static_cast<std::size_t>(runs + lost);
}

}  // namespace

MapResult make_map(const Map& map, const StudyOptions& options) {
  const Study& study = map.study;
  const auto lock = take_folder(options, study.file);
  const std::vector<StudyRun> alone{{study, options.out}};
  Scheduler::Outcome all = Scheduler(alone, options).run_all();
  const auto tables = take_tables(options, study.file);
  auto& [runs, sequences, is_whole, unfinished] = all.studies.front();
  Outcome outcome;
  for (const FinishedRun& run : runs) {
    outcome.verdicts.push_back(verdict_of(study.criterion, run));
    outcome.theory.push_back(theory_of(map, run, options.out));
  }
  outcome.finished = is_whole;
  outcome.decided_by = rows_of(sequences.deciding(), runs);
  if (!outcome.finished) keep_own(runs, outcome.decided_by);
  outcome.bisections = sequences.bisections();
  outcome.runs = std::move(runs);
  StudyTable table = run_table(study, outcome.runs);
  table.columns.push_back({"verdict", "how the run stands to the criterion", "", outcome.verdicts});
  write_table(options.out / "table", table, study, options.command);
  write_table(options.out / "map", squares_table(map, outcome), study, options.command);
  MapResult result{report_text(map, outcome), all.signal, count_file_trouble(outcome.runs),
                   count_telling_nothing(outcome), unfinished};
  replace_file(options.out / "map.txt", result.report);
  return result;
}

}  // namespace tether::map
