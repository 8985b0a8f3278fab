// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/automatic/find_setting.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "base/diagnostics.hpp"
#include "base/file.hpp"
#include "base/process.hpp"
#include "results/text_file.hpp"
#include "studies/automatic/report.hpp"
#include "studies/combinations.hpp"
#include "studies/reproduce/files.hpp"
#include "studies/run_pool.hpp"
#include "studies/sweep.hpp"

namespace tether::automatic {
namespace {

namespace fs = std::filesystem;

/// Digits of a run's key that make the name of its folder.
constexpr std::size_t digits_in_a_name = 12;

/// By how much the steps of an ensemble differ from a run's own, on either side.
constexpr double varied_fraction = 0.005;
/// A scatter that is less than this part of the tolerance says nothing.
constexpr double scatter_that_counts = 0.1;
/// What is left of it on finer cells where it is chaos: more than this part.
constexpr double scatter_that_stays = 0.5;

/// A folder of its own, by what makes it this run: searches for other tolerances find it again.
StudyRun run_of(const Automatic& automatic, const Resolution& at, const fs::path& out) {
  Study study = study_of_run(automatic, automatic.refinement.overrides(at));
  const std::string key = run_key(read_deck(study, {0, {}}));
  return {std::move(study), out / "trials" / key.substr(0, digits_in_a_name)};
}

/// The runs of one search, in the order in which they were made.
class Runs {
 public:
  Runs(const Automatic& automatic, const FindOptions& options) : automatic_(automatic), options_(options) {}

  /// Those at these resolutions; what has not failed shows its number and its cost.
  std::vector<TrialRun> make(const std::vector<Resolution>& wanted) const {
    std::vector<StudyRun> runs;
    for (const Resolution& at : wanted) runs.push_back(run_of(automatic_, at, options_.out));
    const auto ends = run_all(runs, options_.shares, options_.command, options_.progress);
    std::vector<TrialRun> all;
    for (std::size_t k = 0; k < ends.size(); ++k) {
      refuse_file_trouble(ends[k]);
      all.push_back({.trial = trial_of(wanted[k], ends[k]),
                     .settings = automatic_.refinement.overrides(wanted[k]),
                     .ending = ends[k].ending,
                     .folder = ends[k].folder});
    }
    return all;
  }

 private:
  static void refuse_file_trouble(const RunEnd& end) {
    if (end.ending.exit_code == exit_file)
      throw FileError(fmt::format("{}; the same command tries the run again", end.ending.message));
  }

  Trial trial_of(const Resolution& wanted, const RunEnd& end) const {
    Trial trial{.at = automatic_.refinement.rounded(wanted), .wanted = wanted, .value = {}, .seconds = 0};
    if (end.ending.exit_code != exit_done) return trial;
    const published::RunFiles files(end.folder);
    trial.seconds = files.summary("cpu_seconds");
    const double value = number_or_none(automatic_.value, files);
    if (std::isfinite(value)) trial.value = value;
    return trial;
  }

  const Automatic& automatic_;
  const FindOptions& options_;
};

/// How far values lie apart whose steps differ by little: from what a straight line through them leaves, since a step
/// that is a little longer has a value that is a little other.
double scatter_of(double shorter, double own, double longer) {
  const double mean = (shorter + own + longer) / 3;
  return mean == 0 ? 0 : std::abs(shorter - 2 * own + longer) / (std::sqrt(6.) * std::abs(mean));
}

/// Finds out whether a number scatters, by runs at a level whose steps are varied.
class Ensembles {
 public:
  Ensembles(const Runs& runs, std::vector<TrialRun>& made) : runs_(runs), made_(made) {}

  /// Chaos has as much scatter on finer cells. What falls with them is an error like any other.
  void look(Search& search, double tolerance) {
    if (settled_) return;
    const auto at = search.to_vary();
    if (!at || (first_ > 0 && search.trials().size() < next_look_)) return;
    const double scatter = scatter_at(*at, *search.trials().back().value);
    if (first_ == 0) {
      first_ = scatter, next_look_ = search.trials().size() + 2;
      settled_ = scatter < scatter_that_counts * tolerance;
      return;
    }
    settled_ = true;
    if (scatter > scatter_that_stays * first_) search.take_scatter(scatter);
  }

 private:
  double scatter_at(const Resolution& at, double own) {
    const auto pair =
        runs_.make({{at.space, at.time / (1 + varied_fraction)}, {at.space, at.time * (1 + varied_fraction)}});
    for (TrialRun run : pair) {
      run.varied = true;
      made_.push_back(run);
    }
    if (!pair[0].trial.value || !pair[1].trial.value) return 0;
    return scatter_of(*pair[1].trial.value, own, *pair[0].trial.value);
  }

  const Runs& runs_;
  std::vector<TrialRun>& made_;
  double first_ = 0;
  std::size_t next_look_ = 0;
  bool settled_ = false;
};

/// Makes what the search asks for until it asks for no more.
std::vector<TrialRun> make_all(Search& search, const Automatic& automatic, const FindOptions& options) {
  const Runs runs(automatic, options);
  std::vector<TrialRun> made;
  Ensembles ensembles(runs, made);
  for (auto wanted = search.next(); !wanted.empty(); wanted = search.next()) {
    const auto ended = runs.make(wanted);
    for (const TrialRun& run : ended) {
      search.take(run.trial);
      made.push_back(run);
    }
    if (ended.back().trial.value) ensembles.look(search, automatic.aim.tolerance);
  }
  return made;
}

/// The place of the chosen run among those that were made.
std::size_t place_of(const Search& search, const std::vector<TrialRun>& made) {
  const Resolution at = search.trials()[search.found()->trial].at;
  const auto found = std::ranges::find_if(made, [&](const TrialRun& run) { return !run.varied && run.trial.at == at; });
  return static_cast<std::size_t>(found - made.begin());
}

}  // namespace

Found find_setting(const Automatic& automatic, const FindOptions& options) {
  Search search(automatic.aim);
  const auto made = make_all(search, automatic, options);
  Found found;
  std::optional<std::size_t> chosen;
  if (search.found()) chosen = place_of(search, made);
  const StudyTable table = table_of(made, search);
  write_table(options.out / "auto", table, automatic.study, options.command);
  found.report = report_text(automatic, search, made, chosen, table);
  replace_file(options.out / "auto.txt", found.report);
  found.why_not = search.why_not();
  if (chosen) {
    found.folder = made[*chosen].folder;
    replace_file(options.out / chosen_deck, read_file(found.folder / "deck.effective"));
  } else {
    fs::remove(options.out / chosen_deck);
  }
  return found;
}

std::string list_first_runs(const Automatic& automatic, const fs::path& out) {
  std::string text;
  Search search(automatic.aim);
  for (const Resolution& at : search.next()) {
    const StudyRun run = run_of(automatic, at, out);
    text += list_runs(run.study, run.out);
  }
  return text;
}

}  // namespace tether::automatic
