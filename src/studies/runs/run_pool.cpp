// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/runs/run_pool.hpp"

#include "base/diagnostics.hpp"
#include "studies/sweep.hpp"

namespace tether {
namespace {

double cpu_seconds_of(const std::vector<FinishedRun>& runs) {
  double sum = 0;
  for (const FinishedRun& run : runs) sum += run.record.cpu_seconds;
  return sum;
}

/// A bisection is read from the folder of its tables.
RunEnd end_of_bisection(const StudyRun& each, const StudyOutcome& outcome, const std::string& command) {
  const SweepResult result = report_study(each.study, each.out, outcome, command);
  RunEnd end{{}, each.out, cpu_seconds_of(outcome.runs)};
  if (!result.verdicts.empty()) end.ending = {exit_run, result.verdicts.front()};
  if (!outcome.is_whole) end.ending = {exit_none, "it is not finished"};
  return end;
}

RunEnd end_of_run(const StudyRun& each, const StudyOutcome& outcome) {
  if (outcome.runs.empty()) return {{exit_none, "it is not finished"}, each.out};
  const RunRecord& record = outcome.runs.front().record;
  return {record.ending, run_folder(each.out, record.key), record.cpu_seconds};
}

}  // namespace

std::vector<RunEnd> run_each(const std::vector<StudyRun>& studies, const StudyOptions& options) {
  const Scheduler::Outcome all = Scheduler(studies, options).run_all();
  if (all.signal != 0) throw Interrupted(all.signal, "interrupted; the same command goes on where this one was");
  std::vector<RunEnd> ends;
  for (std::size_t k = 0; k < studies.size(); ++k) {
    const bool bisects = studies[k].study.bisects();
    ends.push_back(bisects ? end_of_bisection(studies[k], all.studies[k], options.command)
                           : end_of_run(studies[k], all.studies[k]));
  }
  return ends;
}

}  // namespace tether
