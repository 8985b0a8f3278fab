// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/automatic/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"

namespace tether::automatic {
namespace {

/// The values of the runs judged by all of them; none where no run shows one.
struct Judged {
  std::vector<double> error, bound;
};

Judged judged(const std::vector<TrialRun>& made, const Search& search) {
  Judged all{std::vector<double>(made.size(), no_number), std::vector<double>(made.size(), no_number)};
  const bool any = std::ranges::any_of(search.trials(), [](const Trial& trial) { return trial.value.has_value(); });
  if (!any) return all;
  const Posterior posterior = search.posterior();
  for (std::size_t k = 0; k < made.size(); ++k) {
    if (!made[k].trial.value) continue;
    const double value = *made[k].trial.value, limit = posterior.limit();
    all.error[k] = (value - limit) / std::abs(limit);
    all.bound[k] = posterior.bound(value, promise);
  }
  return all;
}

TableColumn column(const char* name, const char* meaning, std::vector<double> cells, const char* unit = "1") {
  return {name, meaning, unit, std::move(cells)};
}

std::string order_text(const char* where, const std::optional<double>& order, const std::optional<double>& theory) {
  if (!order) return "";
  return fmt::format("{}order in {} {:.2g} (theory {:.2g}", *order < 0.6 * *theory ? "only " : "", where, *order,
                     *theory) +
         ")\n";
}

std::string doubt_text(const Search& search) {
  if (search.scatter() == 0) return "";
  return fmt::format(
      "the number scatters by {:.2g} of it where steps differ by half a per cent, and finer cells do not mend that\n",
      search.scatter());
}

std::string chosen_text(const Ended& ended) {
  const std::vector<TrialRun>& made = ended.made;
  const std::size_t chosen = *ended.chosen;
  double finest = 0, all = 0;
  for (const TrialRun& run : made) finest = std::max(finest, run.trial.seconds), all += run.trial.seconds;
  const Setting& setting = *ended.search.found();
  return fmt::format(
      "chosen: run {}, with {}\n"
      "its error is {:+.2g} %, and within {:.2g} % with a chance of {:.0f} %\n"
      "it costs {:.3g} s of the processor; the most costly run {:.3g} s, all runs of the search {:.3g} s\n",
      chosen + 1, fmt::join(made[chosen].settings, " "), 100 * setting.error,
      100 * (setting.bound + ended.simplified.change), 100 * promise, made[chosen].trial.seconds, finest, all);
}

std::string failures_text(const std::vector<TrialRun>& made) {
  std::string text;
  for (std::size_t k = 0; k < made.size(); ++k) {
    if (made[k].ending.exit_code != exit_done)
      text += fmt::format("run {} failed: {}\n", k + 1, made[k].ending.message);
    else if (!made[k].trial.value)
      text += fmt::format("run {} ended well, and does not show the number\n", k + 1);
  }
  return text;
}

}  // namespace

StudyTable table_of(const std::vector<TrialRun>& made, const Search& search) {
  std::vector<double> number, space, time, value, seconds, exit_code;
  std::vector<std::string> of, settings, folder;
  for (const TrialRun& run : made) {
    number.push_back(static_cast<double>(number.size() + 1));
    of.push_back(run.of);
    space.push_back(run.trial.at.space), time.push_back(run.trial.at.time);
    value.push_back(run.trial.value.value_or(no_number)), seconds.push_back(run.trial.seconds);
    exit_code.push_back(run.ending.exit_code);
    settings.push_back(fmt::format("{}", fmt::join(run.settings, " "))), folder.push_back(run.folder.string());
  }
  auto [error, bound] = judged(made, search);
  return {
      "run",
      {column("run", "number of the run", number),
       {"of", "what the run is for: a level of refinement, the scatter at one, or the model with and without a part",
        "", of},
       column("space", "how much finer its cells are than the deck's", space),
       column("time", "how much finer its steps are", time),
       column("value", "what was read off the run", value, ""),
       column("error", "estimated: its distance from the limit of all runs, over that", error),
       column("bound", "what the error is within, with the chance that is promised", bound),
       column("cpu_seconds", "of the run", seconds, "s"),
       column("exit_code", "0 for a run that ended well", exit_code),
       {"settings", "values that the run has in place of the deck's", "", settings},
       {"folder", "the run's", "", folder}}};
}

std::string report_text(const Ended& ended, const StudyTable& table) {
  const auto& [automatic, search, simplified, made, chosen] = ended;
  std::string text = fmt::format("{} to {:.3g} %\n", automatic.quantity, 100 * automatic.aim.tolerance);
  text += aligned_text(table, {"run", "of", "space", "time", "value", "error", "bound", "cpu_seconds"});
  text += failures_text(made) + decisions_text(simplified.decisions);
  const bool any = std::ranges::any_of(search.trials(), [](const Trial& trial) { return trial.value.has_value(); });
  if (any) {
    const Orders orders = search.posterior().orders();
    text += order_text("space", orders.space, automatic.aim.theory.space);
    text += order_text("time", orders.time, automatic.aim.theory.time);
  }
  text += doubt_text(search);
  return text + (chosen ? chosen_text(ended) : fmt::format("cannot promise: {}\n", search.why_not()));
}

}  // namespace tether::automatic
