// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "plan/plan.hpp"
#include "run_options.hpp"
#include "studies/runs/scheduler.hpp"

namespace tether {

/// Does what the command line asks of a study other than to make all of it here: lists its runs or the commands of its
/// parts, has Slurm do the parts that are not finished, or does some parts for who collects them. False where it asks
/// for none of it; then nobody asks for the study's runs, which may take long to find. Throws InputError, FileError,
/// Interrupted.
bool is_done_otherwise(const std::string& name, const std::function<std::vector<StudyRun>()>& studies,
                       const StudyOptions& how, const RunOptions& options);

/// Has Slurm do a run, which goes on from its checkpoint where its time ends first. Throws InputError, FileError.
void hand_over_run(const std::string& name, const Cost& cost, const std::filesystem::path& folder,
                   const RunOptions& options);

/// Refuses several studies where parts are asked for: the words of one stand in the commands. Throws InputError.
void refuse_parts_of_several(const std::vector<std::string>& studies, const RunOptions& options);

}  // namespace tether
