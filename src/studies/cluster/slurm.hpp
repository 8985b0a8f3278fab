// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "plan/plan.hpp"
#include "studies/runs/parts.hpp"

namespace tether::slurm {

/// What a job of Slurm does: some parts of a study, one after the other.
struct Job {
  std::vector<std::size_t> parts;     ///< their numbers
  double seconds = 0, megabytes = 0;  ///< expected: of the processor in all, the most memory
};

/// Puts parts together into jobs of a minute at least, the longest parts first, and into no more jobs than Slurm takes
/// in one array by default.
std::vector<Job> jobs_of(std::vector<PartCost> parts);

/// What the jobs run, and where.
struct Work {
  std::filesystem::path folder;      ///< of the results; script and logs go to slurm/ in it
  std::filesystem::path here;        ///< from where the command's paths count
  std::vector<std::string> command;  ///< program and words
  int cpus = 1;                      ///< of each job
};

/// The script of an array of jobs: each does its parts by the command with `--part` and is queued again where its time
/// ends before they do. Whatever is in names, the shell takes it for names.
std::string script_of(const Work& work, const std::vector<Job>& jobs);
/// The script of one job that runs the command as it is.
std::string script_of(const Work& work, const Cost& cost);

/// Throws InputError where there is no Slurm.
void refuse_no_slurm();
/// Throws InputError where Slurm still has the job that submit() has handed over for this folder of results: its parts
/// are not to be done twice.
void refuse_queued(const std::filesystem::path& folder);
/// Writes slurm/job.sh into the work's folder; returns its path. Throws FileError.
std::filesystem::path write_script(const Work& work, const std::string& script);
/// Hands a script to sbatch, and writes the job's number to job.txt next to it; returns what sbatch says. Throws
/// FileError where it does not take the script.
std::string submit(const std::filesystem::path& script);

}  // namespace tether::slurm
