// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/automatic/find_setting.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/file.hpp"
#include "results/text_file.hpp"
#include "studies/automatic/ensembles.hpp"
#include "studies/automatic/model_search.hpp"
#include "studies/automatic/report.hpp"
#include "studies/sweep.hpp"

namespace tether::automatic {
namespace {

namespace fs = std::filesystem;

/// What is left out is looked at again at a level that costs less than this part of the search's most costly run.
constexpr double share_of_the_check = 0.15;

/// A search, and whether the model can do without what it leaves out.
struct Attempt {
  Search search;
  std::optional<Resolution> counts_at = {};  ///< where it changes the number by too much; none where nowhere
  bool fails = false;                        ///< the deck's own cells and steps, and finer ones, fail without it
};

bool is_twice_as_fine(const Resolution& a, const Resolution& b, const Aim& aim) {
  return (!aim.theory.space || a.space >= 2 * b.space) && (!aim.theory.time || a.time >= 2 * b.time);
}

/// The level at which what is left out is looked at again: the most costly one that costs little; else the cheapest
/// that is twice as fine as the one of the pairs. None before there is one.
const Trial* level_to_check(const Search& search, const Simplified& simplified, const Aim& aim) {
  double most = 0;
  for (const Trial& trial : search.trials()) most = std::max(most, trial.seconds);
  const Trial *cheapest = nullptr, *costs_little = nullptr;
  for (const Trial& trial : search.trials()) {
    if (!trial.value || !is_twice_as_fine(trial.wanted, simplified.whole.wanted, aim)) continue;
    if (!cheapest || trial.seconds < cheapest->seconds) cheapest = &trial;
    const bool is_better = !costs_little || trial.seconds > costs_little->seconds;
    if (is_better && simplified.saving * trial.seconds < share_of_the_check * most) costs_little = &trial;
  }
  return costs_little ? costs_little : cheapest;
}

/// What a search of a model that is solved that way is after.
Aim aim_of(const Automatic& automatic, Way way) {
  Aim aim = automatic.aim;
  if (way == Way::elements) aim.theory = automatic.by_elements, aim.nested = false;
  return aim;
}

/// A search for a simplified model, which looks again on finer cells at what the model leaves out.
class ModelAttempt {
 public:
  /// The references must outlive this.
  ModelAttempt(const Automatic& automatic, TrialRuns& runs, Simplified& simplified)
      : automatic_(automatic),
        runs_(runs),
        simplified_(simplified),
        made_{.search = Search(aim_of(automatic, simplified.left_out.way))},
        ensembles_(runs, simplified.left_out) {
    tighten();
  }

  /// Makes what the search asks for until it asks for no more, or what the model leaves out turns out to count.
  Attempt make() {
    for (;;) {
      const std::vector<Resolution> levels = made_.search.next(runs_.spent());
      if (levels.empty()) {
        if (!made_.search.found() || is_same_at(made_.search.found()->trial.wanted)) break;
      } else {
        make_levels(levels);
        is_same_at({1, 1});
      }
      if (made_.counts_at) return std::move(made_);
    }
    made_.fails = made_.search.own_size_fails();
    return std::move(made_);
  }

 private:
  void tighten() { made_.search.tighten(automatic_.aim.tolerance - simplified_.allowed); }

  void make_levels(const std::vector<Resolution>& levels) {
    std::vector<WantedRun> wanted;
    for (const Resolution& at : levels) wanted.push_back({at, simplified_.left_out});
    for (const Trial& trial : runs_.make(wanted)) made_.search.take(trial);
    ensembles_.look(made_.search, automatic_.aim);
  }

  /// Returns whether what the model leaves out changes the number at that level by no more than is allowed. Else the
  /// search has less of the tolerance from now on, or none. What the budget does not reach is not looked at.
  bool is_same_at(const Resolution& at) {
    const Aim& aim = automatic_.aim;
    const Trial* level = simplified_.leaves_out() ? level_to_check(made_.search, simplified_, aim) : nullptr;
    if (level == nullptr || runs_.spent() + simplified_.saving * level->seconds > aim.budget) return true;
    const double change = change_at(at, *level, runs_, simplified_);
    const bool is_out_of_budget = std::isnan(change) && runs_.spent() >= aim.budget;
    if (change <= simplified_.allowed || is_out_of_budget) return true;
    if (change < most_change(aim.tolerance)) {
      simplified_.allowed = change;
      tighten();
    } else {
      made_.counts_at = level->wanted;
    }
    return false;
  }

  const Automatic& automatic_;
  TrialRuns& runs_;
  Simplified& simplified_;
  Attempt made_;
  Ensembles ensembles_;
};

}  // namespace

Found find_setting(const Automatic& automatic, const StudyOptions& options) {
  const FolderLock lock(options.out, automatic.study.file, Sharing::alone);
  TrialRuns runs(automatic, options);
  Simplified simplified = simplify(automatic, runs);
  Attempt made = ModelAttempt(automatic, runs, simplified).make();
  while (simplified.leaves_out() && (made.counts_at || made.fails)) {
    if (made.counts_at)
      decide_again(*made.counts_at, simplified, automatic, runs);
    else
      keep_all(simplified, "runs without it fail on finer cells");
    made = ModelAttempt(automatic, runs, simplified).make();
  }
  const Search& search = made.search;
  const StudyTable table = table_of(runs.made(), search);
  write_table(options.out / "auto", table, automatic.study, options.command);
  Found result;
  result.report = report_text({automatic, search, simplified, runs}, table);
  replace_file(options.out / "auto.txt", result.report);
  result.why_not = search.why_not();
  if (search.found()) {
    result.folder = runs.made()[search.found()->trial.run].folder;
    replace_file(options.out / chosen_deck, read_file(result.folder / "deck.effective"));
  } else {
    fs::remove(options.out / chosen_deck);
  }
  return result;
}

std::string list_first_runs(const Automatic& automatic, const fs::path& out) {
  std::vector<StudyRun> runs;
  Search search(automatic.aim);
  std::vector<WantedRun> wanted;
  for (const Resolution& at : search.next(0)) wanted.push_back({at});
  for (const Choice& choice : automatic.choices) wanted.push_back({automatic.aim.coarsest, choice.without});
  for (const WantedRun& each : wanted) {
    runs.push_back(study_run_of(automatic, each, out));
  }
  return list_runs(runs);
}

}  // namespace tether::automatic
