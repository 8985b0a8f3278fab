// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/file.hpp"
#include "studies/runs/scheduler.hpp"
#include "studies/study.hpp"
#include "studies/table.hpp"

namespace tether {

/// What a sweep has to say at its end.
struct SweepResult {
  std::string report;                 ///< the tables, for people
  std::vector<std::string> verdicts;  ///< of bisections that found nothing, of columns that no history has
  int signal = 0;                     ///< that interrupted it
  std::size_t file_trouble = 0;       ///< runs that were killed, or could not read or write a file
  std::size_t unfinished = 0;         ///< parts that were to be collected and are not finished
};

/// Runs a study; writes table.nc and table.csv, a row a run, and for ensembles and bisections outcome.nc and
/// outcome.csv, a row a combination, of what is finished, also after a signal. A run that fails is a row like any
/// other. Throws FileError, also where another process works in the same folder.
SweepResult sweep(const Study& study, const StudyOptions& options);

/// Writes the tables of what is finished of a study into its folder, as sweep() does. Throws FileError.
SweepResult report_study(const Study& study, const std::filesystem::path& out, const StudyOutcome& outcome,
                         const std::string& command);

/// Keeps others out of the studies' folder that would do the same runs, as long as what is returned lives, and removes
/// from it what an earlier study, or the same one in another mode, has found, but not its runs. Those who do parts of
/// studies share the folder; who collects keeps others from writing tables alone, from before the look at what is
/// finished. `work` says for others what is done there. Throws FileError.
std::unique_ptr<FolderLock> take_folder(const StudyOptions& options, const std::string& work);

/// Keeps others from writing tables in the folder while these are written; waits for those who do. Nothing where
/// take_folder() has done so. Throws FileError.
std::unique_ptr<FolderLock> take_tables(const StudyOptions& options, const std::string& work);

/// Writes a study's table as STEM.nc and STEM.csv. Throws FileError.
void write_table(const std::filesystem::path& stem, const StudyTable& table, const Study& study,
                 const std::string& command);

/// How many were killed, or could not read or write a file: the next sweep tries them again.
std::size_t count_file_trouble(const std::vector<FinishedRun>& runs);
/// Throws FileError where there are such runs; `first` is what the first of them says, if nothing else says it.
void refuse_file_trouble(std::size_t runs, const std::string& first = {});

/// The runs that are known before the first has ended, a line each: whether it is finished, its deck, its overrides.
std::string list_runs(const std::vector<StudyRun>& studies);

}  // namespace tether
