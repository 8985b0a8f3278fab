// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "base/process.hpp"
#include "studies/automatic/automatic.hpp"
#include "studies/run_pool.hpp"
#include "studies/scheduler.hpp"

namespace tether::automatic {

/// How a search is to be made.
struct FindOptions {
  std::filesystem::path out;  ///< folder for the table and, below it, the runs
  Shares shares;
  std::string command;  ///< as it was typed, for the files' provenance
  std::function<void(const SweepProgress&)> progress;
};

/// A run that is wanted: a resolution, and what the model leaves out.
struct WantedRun {
  Resolution at;
  std::vector<std::string> left_out = {};  ///< overrides of the choices that it leaves out
  std::string of = "level";                ///< what it is for, a word of the table
};

/// A run that was made, and where.
struct TrialRun {
  Trial trial;
  std::string of = {};
  std::vector<std::string> settings = {};  ///< in place of the deck's
  Ending ending = {};
  std::filesystem::path folder = {};
};

/// The runs of a search: made side by side, each in a folder of its own by what makes it this run, so that searches for
/// other tolerances find it again.
class TrialRuns {
 public:
  /// The references must outlive this.
  TrialRuns(const Automatic& automatic, const FindOptions& options) : automatic_(automatic), options_(options) {}

  /// Makes runs, those that were made before by reading what they left. Returns them in their order. Throws FileError
  /// where one could not read or write a file, Interrupted.
  std::vector<TrialRun> make(const std::vector<WantedRun>& wanted);
  /// All that were made, in their order.
  const std::vector<TrialRun>& made() const { return made_; }

 private:
  Trial trial_of(const Resolution& wanted, const RunEnd& end) const;

  const Automatic& automatic_;
  const FindOptions& options_;
  std::vector<TrialRun> made_;
};

/// Returns what a run has in place of the deck's values.
std::vector<std::string> settings_of(const Automatic& automatic, const WantedRun& wanted);

/// The run as a study of its own.
StudyRun study_run_of(const Automatic& automatic, const WantedRun& wanted, const std::filesystem::path& out);

}  // namespace tether::automatic
