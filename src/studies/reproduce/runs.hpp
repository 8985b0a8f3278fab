// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "studies/reproduce/problem.hpp"
#include "studies/scheduler.hpp"
#include "studies/study.hpp"

namespace tether::published {

/// What a run is for.
enum class Role { thesis, robust, thesis_reference, robust_reference };

/// A run of a problem, or a bisection, as a study of its own: so what runs it, knows it again and tells how it ended is
/// what does that for sweeps.
struct PlannedRun {
  std::size_t problem = 0;  ///< in the list of problems
  Role role = Role::thesis;
  Study study;
  std::filesystem::path out;  ///< the study's folder
};

/// How one ended, and the folder that its files are in.
struct RunEnd {
  Ending ending;
  std::filesystem::path folder;
};

/// Runs of a chaotic case, and by how much their steps differ from the deck's on either side.
constexpr int varied_runs = 10;
constexpr double varied_fraction = 0.005;

/// All runs of these problems, each to be written below `out`. Throws InputError for mistakes of their decks, FileError
/// with all decks that cannot be read.
std::vector<PlannedRun> plan_runs(const std::vector<Problem>& problems, const std::filesystem::path& out);

/// Does them, several side by side, each in a process of its own; those that had been finished are not run again.
/// Throws Interrupted, after the runs under way have stopped.
std::vector<RunEnd> run_all(const std::vector<PlannedRun>& runs, Shares shares, const std::string& command,
                            const std::function<void(const SweepProgress&)>& progress);

}  // namespace tether::published
