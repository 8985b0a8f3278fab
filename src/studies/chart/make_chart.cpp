// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/chart/make_chart.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <cmath>

#include "base/diagnostics.hpp"
#include "base/file.hpp"
#include "base/process.hpp"
#include "base/text.hpp"
#include "results/text_file.hpp"
#include "studies/chart/chart_runs.hpp"
#include "studies/reproduce/files.hpp"
#include "studies/run_pool.hpp"
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

/// A number that a run does not show is none.
double read(const published::Readout& readout, const published::RunFiles& files) {
  if (!readout) return NAN;
  try {
    return readout(files);
  } catch (const FileError&) {
    return NAN;
  }
}

Measured measured(const Chart& chart, const RunEnd& end) {
  Measured run;
  if (end.ending.exit_code != exit_done) return run;
  const published::RunFiles files(end.folder);
  run.value = read(chart.value, files), run.exact = read(chart.exact, files);
  run.seconds = files.summary("cpu_seconds"), run.megabytes = files.summary("peak_memory_mb");
  return run;
}

template <class Cell>
TableColumn column(const char* name, const char* meaning, std::vector<Cell> cells, const char* unit = "") {
  return {name, meaning, unit, std::move(cells)};
}

/// A row a run.
StudyTable table_of(const Chart& chart, const std::vector<ChartRun>& runs, const Measurement& measurement,
                    const std::vector<RunEnd>& ends) {
  std::vector<std::string> family, of, values, folder;
  std::vector<double> size, value, error, lasting, seconds, megabytes, exit_code;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const Family& each = chart.families[runs[k].family];
    const Measured& run = measurement.runs[k];
    family.push_back(each.name), of.emplace_back(runs[k].of == Of::cells ? "cells" : "steps");
    values.push_back(fmt::format("{}", fmt::join(runs[k].study.sets, " ")));
    size.push_back((runs[k].of == Of::cells ? each.cells : each.steps).size[runs[k].rung]);
    value.push_back(run.value), error.push_back(run.error), lasting.push_back(run.lasting);
    seconds.push_back(run.seconds), megabytes.push_back(run.megabytes);
    exit_code.push_back(ends[k].ending.exit_code), folder.push_back(ends[k].folder.string());
  }
  return {"run",
          {column("family", "family of runs", family), column("of", "what the run studies: cells or steps", of),
           column("size", "of a cell, over the scene's, or of a step", size),
           column("value", "what was read off the run", value),
           column("error", "its distance from the answer, over the answer", error, "1"),
           column("lasting_error", "the largest of it and of the family's finer meshes, which counts in the front",
                  lasting, "1"),
           column("cpu_seconds", "of the run", seconds, "s"),
           column("peak_memory_mb", "of its process", megabytes, "1e6 byte"),
           column("exit_code", "0 for a run that ended well", exit_code),
           column("settings", "values that the run has in place of the deck's", values),
           column("folder", "the run's", folder)}};
}

std::string failures_text(const std::vector<ChartRun>& runs, const std::vector<RunEnd>& ends) {
  std::string text;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    if (ends[k].ending.exit_code != exit_done)
      text += fmt::format("run {} failed: {}\n", k + 1, ends[k].ending.message);
  }
  return text;
}

}  // namespace

ChartResult make_chart(const Chart& chart, const ChartOptions& options) {
  const std::vector<ChartRun> runs = runs_of(chart);
  const auto ends = run_all(planned(runs, options.out / "runs"), options.shares, options.command, options.progress);
  Measurement measurement;
  for (const auto& end : ends) measurement.runs.push_back(measured(chart, end));
  find_errors(chart, runs, measurement);
  const StudyTable table = table_of(chart, runs, measurement, ends);
  write_netcdf(options.out / "chart.nc", table,
               {chart.study.title, options.command, chart.study.text, sha256(chart.study.text), Units::none});
  replace_file(options.out / "chart.csv", csv_text(table));
  ChartResult result;
  result.report = aligned_text(table, {"family", "of", "size", "value", "error", "lasting_error", "cpu_seconds",
                                       "peak_memory_mb"}) +
                  "\n" + report_text(chart, runs, measurement) + failures_text(runs, ends);
  replace_file(options.out / "chart.txt", result.report);
  for (const auto& end : ends) {
    result.failed += end.ending.exit_code == exit_done ? 0 : 1;
    result.file_trouble += end.ending.exit_code == exit_file ? 1 : 0;
  }
  return result;
}

std::string list_chart_runs(const Chart& chart, const fs::path& out) {
  std::string text;
  for (const auto& run : planned(runs_of(chart), out / "runs")) text += list_runs(run.study, run.out);
  return text;
}

}  // namespace tether::chart
