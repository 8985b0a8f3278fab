// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/automatic/trial_runs.hpp"

#include <fmt/format.h>
#include <cmath>

#include "base/diagnostics.hpp"
#include "studies/combinations.hpp"
#include "studies/reproduce/files.hpp"

namespace tether::automatic {
namespace {

/// Digits of a run's key that make the name of its folder.
constexpr std::size_t digits_in_a_name = 12;

void refuse_file_trouble(const RunEnd& end) {
  if (end.ending.exit_code == exit_file)
    throw FileError(fmt::format("{}; the same command tries the run again", end.ending.message));
}

}  // namespace

std::vector<std::string> settings_of(const Automatic& automatic, const WantedRun& wanted) {
  std::vector<std::string> settings = automatic.refinement.overrides(wanted.at);
  settings.insert(settings.end(), wanted.left_out.begin(), wanted.left_out.end());
  return settings;
}

StudyRun study_run_of(const Automatic& automatic, const WantedRun& wanted, const std::filesystem::path& out) {
  Study study = study_of_run(automatic, settings_of(automatic, wanted));
  const std::string key = run_key(read_deck(study, {0, {}}));
  return {std::move(study), out / "trials" / key.substr(0, digits_in_a_name)};
}

std::vector<TrialRun> TrialRuns::make(const std::vector<WantedRun>& wanted) {
  std::vector<StudyRun> runs;
  for (const WantedRun& run : wanted) runs.push_back(study_run_of(automatic_, run, options_.out));
  const auto progress = [&](SweepProgress all_so_far) {
    all_so_far.done += made_.size();
    if (options_.progress) options_.progress(all_so_far);
  };
  const auto ends = run_all(runs, options_.shares, options_.command, progress);
  std::vector<TrialRun> all;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    refuse_file_trouble(ends[k]);
    all.push_back({.trial = trial_of(wanted[k].at, ends[k]),
                   .of = wanted[k].of,
                   .settings = settings_of(automatic_, wanted[k]),
                   .ending = ends[k].ending,
                   .folder = ends[k].folder});
  }
  made_.insert(made_.end(), all.begin(), all.end());
  return all;
}

Trial TrialRuns::trial_of(const Resolution& wanted, const RunEnd& end) const {
  Trial trial{.at = automatic_.refinement.rounded(wanted), .wanted = wanted, .value = {}, .seconds = 0};
  if (end.ending.exit_code != exit_done) return trial;
  const published::RunFiles files(end.folder);
  trial.seconds = files.summary("cpu_seconds");
  const double value = number_or_none(automatic_.value, files);
  if (std::isfinite(value)) trial.value = value;
  return trial;
}

}  // namespace tether::automatic
