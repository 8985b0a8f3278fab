// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "base/process.hpp"
#include "studies/runs/scheduler.hpp"

namespace tether {

/// How a study of one run, or of a bisection, ended, the folder that its files are in, and what it took of the
/// processor, then or when it was run before.
struct RunEnd {
  Ending ending;
  std::filesystem::path folder;
  double cpu_seconds = 0;
};

/// Does them side by side, and writes the tables of bisections; those runs that had been finished are not run again.
/// Throws Interrupted, after the runs under way have stopped, and FileError.
std::vector<RunEnd> run_each(const std::vector<StudyRun>& studies, const StudyOptions& options);

}  // namespace tether
