// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/automatic/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"

namespace tether::automatic {
namespace {

/// The values of the search's own runs judged by all of them; no numbers for others.
struct Judged {
  std::vector<double> error, bound;
};

Judged judged(std::size_t runs, const Search& search) {
  Judged all{std::vector<double>(runs, no_number), std::vector<double>(runs, no_number)};
  const auto posterior = search.posterior();
  if (!posterior) return all;
  for (const Trial& trial : search.trials()) {
    if (!trial.value) continue;
    all.error[trial.run] = (*trial.value - posterior->limit()) / std::abs(posterior->limit());
    all.bound[trial.run] = posterior->bound(*trial.value, promise);
  }
  return all;
}

std::string order_text(const char* where, const std::optional<double>& order, const std::optional<double>& theory) {
  if (!order) return "";
  constexpr double little = 0.6;
  return fmt::format("{}order in {} {:.2g} (theory {:.2g})\n", *order < little * *theory ? "only " : "", where, *order,
                     *theory);
}

std::string doubt_text(const Search& search) {
  if (search.scatter() == 0) return "";
  return fmt::format(
      "the number scatters by {:.2g} of it where steps differ by half a per cent, and finer cells do not mend that\n",
      search.scatter());
}

std::string chosen_text(const Ended& ended) {
  const Setting& setting = *ended.search.found();
  double most = 0;
  for (const TrialRun& run : ended.runs.made()) most = std::max(most, run.trial.seconds);
  return fmt::format(
      "chosen: run {}, with {}\n"
      "its error is {:+.2g} %, and within {:.2g} % with a chance of {:.0f} %\n"
      "it costs {:.3g} s of the processor; the most costly run {:.3g} s, all runs of the search {:.3g} s\n",
      setting.trial.run + 1, fmt::join(ended.runs.made()[setting.trial.run].settings, " "), 100 * setting.error,
      100 * (setting.bound + ended.simplified.allowed), 100 * promise, setting.trial.seconds, most, ended.runs.spent());
}

bool is_the_same_in_all(const std::vector<Trial>& trials) {
  const auto samples = samples_of(trials);
  return samples.size() > 1 &&
         std::ranges::all_of(samples, [&](const Sample& sample) { return sample.value == samples.front().value; });
}

const char* failed_how(NoValue why) {
  if (why == NoValue::scene) return "cannot be built";
  return why == NoValue::run ? "failed" : "ended well, and does not write what the number is read off";
}

/// A message without its place in a deck that the user did not write.
std::string what_is_wrong(const std::string& message) {
  constexpr std::string_view mark = "error: ";
  const auto at = message.find(mark);
  return at == std::string::npos ? message : message.substr(at + mark.size());
}

std::string failures_text(const std::vector<TrialRun>& made) {
  std::string text;
  for (std::size_t k = 0; k < made.size(); ++k) {
    const auto& [trial, purpose, settings, ending, folder] = made[k];
    if (trial.value || (trial.why == NoValue::scene && purpose == Purpose::model)) continue;
    if (trial.why == NoValue::number)
      text += fmt::format("run {} ended well, and does not show the number\n", k + 1);
    else
      text += fmt::format("run {} {}: {}\n", k + 1, failed_how(trial.why), what_is_wrong(ending.message));
  }
  return text;
}

}  // namespace

StudyTable table_of(const std::vector<TrialRun>& made, const Search& search) {
  std::vector<double> number, space, time, value, seconds, exit_code;
  std::vector<std::string> of, settings, folder;
  for (const TrialRun& run : made) {
    number.push_back(static_cast<double>(number.size() + 1));
    of.emplace_back(word_of(run.purpose));
    space.push_back(run.trial.at.space), time.push_back(run.trial.at.time);
    value.push_back(run.trial.value.value_or(no_number)), seconds.push_back(run.trial.seconds);
    exit_code.push_back(run.ending.exit_code);
    settings.push_back(fmt::format("{}", fmt::join(run.settings, " "))), folder.push_back(run.folder.string());
  }
  auto [error, bound] = judged(made.size(), search);
  return {
      "run",
      {table_column("run", "number of the run", number, "1"),
       table_column("of",
                    "what the run was first made for: a level of refinement, the scatter at one, or the model with "
                    "and without a part",
                    of),
       table_column("space", "how much finer its cells are than the deck's", space, "1"),
       table_column("time", "how much finer its steps are, those that a limit cut as it did", time, "1"),
       table_column("value", "what was read off the run", value),
       table_column("error", "estimated: its distance from the limit of all runs of its model, over that", error, "1"),
       table_column("bound", "what the error is within, with the chance that is promised", bound, "1"),
       table_column("cpu_seconds", "of the run", seconds, "s"),
       table_column("exit_code", "0 for a run that ended well", exit_code, "1"),
       table_column("settings", "values that the run has in place of the deck's", settings),
       table_column("folder", "the run's", folder)}};
}

std::string report_text(const Ended& ended, const StudyTable& table) {
  const auto& [automatic, search, simplified, runs] = ended;
  std::string text = fmt::format("{} to {:.3g} %\n", automatic.quantity, 100 * automatic.aim.tolerance);
  text += aligned_text(table, {"run", "of", "space", "time", "value", "error", "bound", "cpu_seconds"});
  text += failures_text(runs.made()) + decisions_text(simplified.decisions);
  if (is_the_same_in_all(search.trials())) {
    text += "the number is the same in every run: neither cells nor steps change it\n";
  } else if (const auto posterior = search.posterior()) {
    text += order_text("space", posterior->orders().space, automatic.aim.theory.space);
    text += order_text("time", posterior->orders().time, automatic.aim.theory.time);
  }
  text += doubt_text(search);
  return text + (search.found() ? chosen_text(ended) : fmt::format("cannot promise: {}\n", search.why_not()));
}

}  // namespace tether::automatic
