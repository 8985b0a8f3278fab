// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "studies/reproduce/problem.hpp"
#include "studies/runs/run_pool.hpp"
#include "studies/study.hpp"

namespace tether::published {

/// What a run is for.
enum class Role { thesis, robust, thesis_reference, robust_reference };

/// A run of a problem, or a bisection.
struct PlannedRun : StudyRun {
  std::size_t problem = 0;  ///< in the list of problems
  Role role = Role::thesis;
};

/// Runs of a chaotic case, and by how much their steps differ from the deck's on either side.
constexpr int varied_runs = 10;
constexpr double varied_fraction = 0.005;

/// All runs of these problems, each to be written below `out`. Throws InputError for mistakes of their decks, FileError
/// with all decks that cannot be read.
std::vector<PlannedRun> plan_runs(const std::vector<Problem>& problems, const std::filesystem::path& out);

}  // namespace tether::published
