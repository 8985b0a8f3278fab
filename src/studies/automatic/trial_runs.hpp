// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/process.hpp"
#include "base/words.hpp"
#include "studies/automatic/automatic.hpp"
#include "studies/runs/run_pool.hpp"
#include "studies/runs/scheduler.hpp"

namespace tether {

namespace automatic {

/// What a run is for: a level of refinement, the scatter at one, or the model with and without a part.
enum class Purpose { level, scatter, model };

}  // namespace automatic

template <>
inline constexpr std::array<Word<automatic::Purpose>, 3> words<automatic::Purpose>{
    {{automatic::Purpose::level, "level"},
     {automatic::Purpose::scatter, "scatter"},
     {automatic::Purpose::model, "model"}}};

namespace automatic {

/// A run that is wanted: a resolution, and what the model leaves out.
struct WantedRun {
  Resolution at;
  LeftOut left_out = {};
  Purpose purpose = Purpose::level;
  double stretch = 1;  ///< all steps are so much longer
};

/// A run that was made, and where.
struct TrialRun {
  Trial trial;
  Purpose purpose = Purpose::level;        ///< for which it was made first
  std::vector<std::string> settings = {};  ///< in place of the deck's
  Ending ending = {};
  std::filesystem::path folder = {};
};

/// The runs of a search: made side by side, each in a folder of its own by what makes it this run, so that searches for
/// other tolerances find it again.
class TrialRuns {
 public:
  /// The references must outlive this.
  TrialRuns(const Automatic& automatic, const StudyOptions& options) : automatic_(automatic), options_(options) {}

  /// Makes runs, those that were made before by reading what they left. A run that takes more of the processor than the
  /// budget has left is stopped. Returns what they came to, in their order. Throws FileError where one could not read
  /// or write a file, Interrupted.
  std::vector<Trial> make(const std::vector<WantedRun>& wanted);
  /// Each run that was made, once, in their order.
  const std::vector<TrialRun>& made() const { return made_; }
  /// Seconds of the processor that all of them took.
  double spent() const;

 private:
  void read(TrialRun& run) const;
  void add(const WantedRun& wanted, const RunEnd& end);

  const Automatic& automatic_;
  const StudyOptions& options_;
  std::vector<TrialRun> made_;
  std::map<std::filesystem::path, std::size_t> places_;  // of runs among them, by the folders of their studies
};

/// The run as a study of its own.
StudyRun study_run_of(const Automatic& automatic, const WantedRun& wanted, const std::filesystem::path& out);

}  // namespace automatic
}  // namespace tether
