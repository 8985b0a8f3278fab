// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/automatic/trial_runs.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "base/diagnostics.hpp"
#include "studies/combinations.hpp"
#include "studies/reproduce/files.hpp"

namespace tether::automatic {
namespace {

/// Digits of a run's key that make the name of its folder.
constexpr std::size_t digits_in_a_name = 12;

std::vector<std::string> settings_of(const Automatic& automatic, const WantedRun& wanted) {
  std::vector<std::string> settings = automatic.refinement.overrides(wanted.at, wanted.left_out.way, wanted.stretch);
  const std::vector<std::string>& more = wanted.left_out.overrides;
  settings.insert(settings.end(), more.begin(), more.end());
  return settings;
}

void refuse_file_trouble(const RunEnd& end) {
  if (end.ending.exit_code == exit_file)
    throw FileError(fmt::format("{}; the same command tries the run again", end.ending.message));
}

bool ended_badly(const TrialRun& run) { return run.ending.exit_code != exit_done; }

}  // namespace

StudyRun study_run_of(const Automatic& automatic, const WantedRun& wanted, const std::filesystem::path& out) {
  Study study = study_of_run(automatic, settings_of(automatic, wanted));
  const std::string key = run_key(read_deck(study, {0, {}}));
  return {.study = std::move(study), .out = out / "trials" / key.substr(0, digits_in_a_name)};
}

double TrialRuns::spent() const {
  double sum = 0;
  for (const TrialRun& run : made_) sum += run.trial.seconds;
  return sum;
}

std::vector<Trial> TrialRuns::make(const std::vector<WantedRun>& wanted) {
  std::vector<StudyRun> new_ones;
  std::vector<WantedRun> new_wanted;
  std::vector<std::size_t> places;
  for (const WantedRun& run : wanted) {
    StudyRun study = study_run_of(automatic_, run, options_.out);
    study.most_cpu_seconds = automatic_.aim.budget - spent();
    const auto [place, is_new] = places_.try_emplace(study.out, made_.size() + new_ones.size());
    places.push_back(place->second);
    if (is_new) new_ones.push_back(std::move(study)), new_wanted.push_back(run);
  }
  StudyOptions options = options_;
  options.progress = [&](SweepProgress all_so_far) {
    all_so_far.done += made_.size();
    all_so_far.failed += static_cast<std::size_t>(std::ranges::count_if(made_, ended_badly));
    if (options_.progress) options_.progress(all_so_far);
  };
  const auto ends = run_each(new_ones, options);
  for (std::size_t k = 0; k < ends.size(); ++k) add(new_wanted[k], ends[k]);
  std::vector<Trial> all;
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    all.push_back(made_[places[k]].trial);
    all.back().wanted = wanted[k].at;
  }
  return all;
}

/// Reads the number off a run that ended well.
void TrialRuns::read(TrialRun& run) const {
  const published::RunFiles files(run.folder);
  Trial& trial = run.trial;
  trial.seconds = files.summary("cpu_seconds");
  const double steps = automatic_.refinement.fineness(files.summary("time_end") / files.summary("steps"));
  if (steps > is_cut * trial.at.time) trial.at.time = steps;
  try {
    const double value = automatic_.value(files);
    trial.why = NoValue::number;
    if (std::isfinite(value)) trial.value = value;
  } catch (const FileError& error) {
    trial.why = NoValue::file, run.ending.message = error.what();
  }
}

void TrialRuns::add(const WantedRun& wanted, const RunEnd& end) {
  refuse_file_trouble(end);
  const NoValue why = end.ending.exit_code == exit_input ? NoValue::scene : NoValue::run;
  TrialRun run{.trial = {.at = automatic_.refinement.rounded(wanted.at, wanted.left_out.way),
                         .wanted = wanted.at,
                         .value = {},
                         .seconds = end.cpu_seconds,
                         .why = why,
                         .run = made_.size()},
               .purpose = wanted.purpose,
               .settings = settings_of(automatic_, wanted),
               .ending = end.ending,
               .folder = end.folder};
  if (end.ending.exit_code == exit_done) read(run);
  made_.push_back(std::move(run));
}

}  // namespace tether::automatic
