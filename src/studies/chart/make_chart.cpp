// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/chart/make_chart.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <cmath>
#include <map>

#include "base/diagnostics.hpp"
#include "base/file.hpp"
#include "base/process.hpp"
#include "base/text.hpp"
#include "results/text_file.hpp"
#include "studies/chart/chart_runs.hpp"
#include "studies/combinations.hpp"
#include "studies/reproduce/files.hpp"
#include "studies/run_table.hpp"
#include "studies/runs/run_pool.hpp"
#include "studies/sweep.hpp"
#include "studies/table.hpp"

namespace tether::chart {
namespace {

namespace fs = std::filesystem;

/// Each run in a folder of its own; the same ones are known again by their keys there.
std::vector<StudyRun> planned(const std::vector<ChartRun>& runs, const fs::path& out) {
  std::vector<StudyRun> all;
  for (const ChartRun& run : runs) {
    const std::string name =
        fmt::format("{}-{}-{}", run.family + 1, run.of == Of::cells ? "cells" : "steps", run.rung + 1);
    all.push_back({run.study, out / name});
  }
  return all;
}

/// Runs that are the same one are made once.
struct Distinct {
  std::vector<StudyRun> runs;
  std::vector<std::size_t> of;  ///< for each run of the chart its place among them
};

Distinct distinct(const std::vector<StudyRun>& runs) {
  std::map<std::string, std::size_t> place;  // by key
  Distinct all;
  for (const StudyRun& run : runs) {
    const std::string key = run_key(read_deck(run.study, combinations(run.study).front()));
    const auto [found, fresh] = place.try_emplace(key, all.runs.size());
    if (fresh) all.runs.push_back(run);
    all.of.push_back(found->second);
  }
  return all;
}

std::vector<RunEnd> run_each_once(const std::vector<StudyRun>& runs, const StudyOptions& options) {
  const Distinct made = distinct(runs);
  const auto ends = run_each(made.runs, options);
  std::vector<RunEnd> all;
  for (const std::size_t k : made.of) all.push_back(ends[k]);
  return all;
}

Measured measured(const Chart& chart, const RunEnd& end) {
  Measured run;
  if (end.ending.exit_code != exit_done) return run;
  const published::RunFiles files(end.folder);
  run.value = number_or_none(chart.value, files), run.exact = number_or_none(chart.exact, files);
  run.seconds = files.summary("cpu_seconds"), run.megabytes = files.summary("peak_memory_mb");
  run.step = files.summary("time_end") / files.summary("steps");
  return run;
}

/// A row a run.
StudyTable table_of(const Chart& chart, const std::vector<ChartRun>& runs, const Measurement& measurement,
                    const std::vector<RunEnd>& ends) {
  std::vector<std::string> family, of, values, folder;
  std::vector<double> number, size, value, error, lasting, seconds, megabytes, warnings, exit_code;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const Family& each = chart.families[runs[k].family];
    const Measured& run = measurement.runs[k];
    family.push_back(each.name), of.emplace_back(runs[k].of == Of::cells ? "cells" : "steps");
    values.push_back(fmt::format("{}", fmt::join(runs[k].study.sets, " ")));
    number.push_back(static_cast<double>(k + 1));
    size.push_back(runs[k].of == Of::cells ? each.cells.size[runs[k].rung] : run.step);
    value.push_back(run.value), error.push_back(run.error), lasting.push_back(run.lasting);
    seconds.push_back(run.seconds), megabytes.push_back(run.megabytes);
    warnings.push_back(count_warnings(ends[k].ending));
    exit_code.push_back(ends[k].ending.exit_code), folder.push_back(ends[k].folder.string());
  }
  return {"run",
          {table_column("run", "number of the run", number, "1"), table_column("family", "family of runs", family),
           table_column("of", "what the run studies: cells or steps", of),
           table_column("size", "of a cell, over the scene's, or the mean of the run's steps", size),
           table_column("value", "what was read off the run", value),
           table_column("error", "its distance from the answer, over the answer", error, "1"),
           table_column("lasting_error",
                        "the largest of it, of the family's finer meshes, and of what a converged answer may be off",
                        lasting, "1"),
           table_column("cpu_seconds", "of the run", seconds, "s"),
           table_column("peak_memory_mb", "of its process", megabytes, "1e6 byte"),
           table_column("warnings", "of the run, which stand in messages.txt of its folder", warnings, "1"),
           table_column("exit_code", "0 for a run that ended well", exit_code),
           table_column("settings", "values that the run has in place of the deck's", values),
           table_column("folder", "the run's", folder)}};
}

std::string failures_text(const std::vector<Measured>& runs, const std::vector<RunEnd>& ends) {
  std::string text;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    if (ends[k].ending.exit_code == exit_none)
      text += fmt::format("run {} is not finished\n", k + 1);
    else if (ends[k].ending.exit_code != exit_done)
      text += fmt::format("run {} failed: {}\n", k + 1, ends[k].ending.message);
    else if (!std::isfinite(runs[k].value))
      text += fmt::format("run {} ended well, and does not show the number that is read off\n", k + 1);
  }
  return text;
}

}  // namespace

ChartResult make_chart(const Chart& chart, const StudyOptions& options) {
  const auto lock = take_folder(options, chart.study.file);
  const std::vector<ChartRun> runs = runs_of(chart);
  const auto ends = run_each_once(planned(runs, options.out / "runs"), options);
  const auto tables = take_tables(options, chart.study.file);
  Measurement measurement;
  for (const auto& end : ends) measurement.runs.push_back(measured(chart, end));
  find_errors(chart, runs, measurement);
  const StudyTable table = table_of(chart, runs, measurement, ends);
  write_table(options.out / "chart", table, chart.study, options.command);
  ChartResult result;
  for (const auto& end : ends) {
    result.failed += end.ending.exit_code == exit_done ? 0 : 1;
    result.file_trouble += is_lost(end.ending) ? 1U : 0U;
    result.unfinished += end.ending.exit_code == exit_none ? 1 : 0;
  }
  if (result.unfinished > 0)
    result.report =
        fmt::format("NOT FINISHED: what follows is of {} runs of {}\n\n", ends.size() - result.unfinished, ends.size());
  result.report += aligned_text(table, {"run", "family", "of", "size", "value", "error", "lasting_error", "cpu_seconds",
                                        "peak_memory_mb", "warnings"}) +
                   "\n" + report_text(chart, runs, measurement) + failures_text(measurement.runs, ends);
  replace_file(options.out / "chart.txt", result.report);
  result.shows_nothing =
      std::ranges::none_of(measurement.runs, [](const Measured& run) { return std::isfinite(run.error); });
  return result;
}

std::vector<StudyRun> study_runs_of(const Chart& chart, const fs::path& out) {
  return distinct(planned(runs_of(chart), out / "runs")).runs;
}

}  // namespace tether::chart
