// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/automatic/find_setting.hpp"

#include <algorithm>
#include <cmath>

#include "base/file.hpp"
#include "results/text_file.hpp"
#include "studies/automatic/ensembles.hpp"
#include "studies/automatic/model_search.hpp"
#include "studies/automatic/report.hpp"
#include "studies/sweep.hpp"

namespace tether::automatic {
namespace {

namespace fs = std::filesystem;

/// Makes what a search asks for until it asks for no more.
void make_all(Search& search, TrialRuns& runs, const std::vector<std::string>& left_out, double tolerance) {
  Ensembles ensembles(runs, left_out);
  for (auto levels = search.next(); !levels.empty(); levels = search.next()) {
    std::vector<WantedRun> wanted;
    for (const Resolution& at : levels) wanted.push_back({at, left_out});
    const auto ended = runs.make(wanted);
    for (const TrialRun& run : ended) search.take(run.trial);
    if (ended.back().trial.value) ensembles.look(search, tolerance);
  }
}

/// The place of the chosen run among those that were made.
std::size_t place_of(const Search& search, const std::vector<TrialRun>& made,
                     const std::vector<std::string>& settings) {
  const Resolution wanted = search.trials()[search.found()->trial].wanted;
  const auto found = std::ranges::find_if(made, [&](const TrialRun& run) {
    return run.of == "level" && run.trial.wanted == wanted && run.settings == settings;
  });
  return static_cast<std::size_t>(found - made.begin());
}

/// A search of the model without what is left out, and whether it holds against the model with it.
struct Attempt {
  Search search;
  std::optional<std::size_t> chosen;  ///< its place among the runs that were made
};

Attempt attempt(const Automatic& automatic, TrialRuns& runs, const Simplified& simplified) {
  Aim aim = automatic.aim;
  aim.tolerance -= simplified.change;
  Attempt made{Search(aim), std::nullopt};
  make_all(made.search, runs, simplified.left_out, aim.tolerance);
  if (!made.search.found()) return made;
  const Resolution at = made.search.trials()[made.search.found()->trial].wanted;
  const auto settings = settings_of(automatic, {at, simplified.left_out});
  made.chosen = place_of(made.search, runs.made(), settings);
  return made;
}

}  // namespace

Found find_setting(const Automatic& automatic, const FindOptions& options) {
  TrialRuns runs(automatic, options);
  Simplified simplified = simplify(automatic, runs);
  Attempt found = attempt(automatic, runs, simplified);
  if (!simplified.left_out.empty() &&
      (!found.chosen || !holds(automatic, runs, simplified, runs.made()[*found.chosen]))) {
    keep_all(simplified);
    found = attempt(automatic, runs, simplified);
  }
  const StudyTable table = table_of(runs.made(), found.search);
  write_table(options.out / "auto", table, automatic.study, options.command);
  Found result;
  result.report = report_text({automatic, found.search, simplified, runs.made(), found.chosen}, table);
  replace_file(options.out / "auto.txt", result.report);
  result.why_not = found.search.why_not();
  if (found.chosen) {
    result.folder = runs.made()[*found.chosen].folder;
    replace_file(options.out / chosen_deck, read_file(result.folder / "deck.effective"));
  } else {
    fs::remove(options.out / chosen_deck);
  }
  return result;
}

std::string list_first_runs(const Automatic& automatic, const fs::path& out) {
  std::string text;
  Search search(automatic.aim);
  for (const Resolution& at : search.next()) {
    const StudyRun run = study_run_of(automatic, {at}, out);
    text += list_runs(run.study, run.out);
  }
  return text;
}

}  // namespace tether::automatic
