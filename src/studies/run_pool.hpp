// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "base/process.hpp"
#include "studies/scheduler.hpp"
#include "studies/study.hpp"

namespace tether {

/// A run, or a bisection, as a study of its own: so what runs it, knows it again and reports how it ended is what does
/// that for sweeps.
struct StudyRun {
  Study study;
  std::filesystem::path out;                                          ///< the study's folder
  double most_cpu_seconds = std::numeric_limits<double>::infinity();  ///< a run that takes more is stopped
};

/// How one ended, the folder that its files are in, and what it took of the processor, then or when it was run before.
struct RunEnd {
  Ending ending;
  std::filesystem::path folder;
  double cpu_seconds = 0;
};

/// Does them, several side by side, each in a process of its own; those that had been finished are not run again.
/// Throws Interrupted, after the runs under way have stopped.
std::vector<RunEnd> run_all(const std::vector<StudyRun>& runs, Shares shares, const std::string& command,
                            const std::function<void(const SweepProgress&)>& progress);

}  // namespace tether
