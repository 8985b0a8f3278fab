// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "studies/chart/chart.hpp"
#include "studies/runs/scheduler.hpp"

namespace tether::chart {

/// What there is to say at the end.
struct ChartResult {
  std::string report;            ///< for people
  std::size_t failed = 0;        ///< runs that did not end well
  bool shows_nothing = false;    ///< no run has an error: there is no answer, or no value
  std::size_t file_trouble = 0;  ///< of them those that could not read or write a file
  std::size_t unfinished = 0;    ///< of them those that were to be collected and are not finished
};

/// Runs all families and writes chart.nc, chart.csv and chart.txt, the report. Throws FileError, Interrupted.
ChartResult make_chart(const Chart& chart, const StudyOptions& options);

/// Returns its runs as studies of their own, each once.
std::vector<StudyRun> study_runs_of(const Chart& chart, const std::filesystem::path& out);

}  // namespace tether::chart
