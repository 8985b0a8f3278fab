// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/sweep.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <set>

#include "base/diagnostics.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "results/text_file.hpp"
#include "studies/run_table.hpp"

namespace tether {
namespace {

namespace fs = std::filesystem;

/// Writes the report for people: without what is wide, and without the axes that only follow.
std::string report_text(const Study& study, const StudyTable& table) {
  std::set<std::string> hidden{"wall_seconds", "message", "folder", "reused"};
  if (study.decks.size() == 1) hidden.insert("deck");
  for (std::size_t a = 0; a < study.axes.size(); ++a) {
    if (study.axes[a].leader != a) hidden.insert(study.axes[a].variable);
  }
  std::vector<std::string> names;
  for (const auto& column : table.columns) {
    if (hidden.count(column.name) == 0) names.push_back(column.name);
  }
  return aligned_text(table, names);
}

std::string failures_text(const std::vector<FinishedRun>& runs) {
  std::string text;
  int number = 1;
  for (const auto& run : runs) {
    if (run.failed()) text += fmt::format("run {}: {}\n", number, run.record.ending.message);
    ++number;
  }
  return text;
}

/// The bisections that found nothing: both ends agree, or a run ended that says nothing.
std::vector<std::string> broken_verdicts(const Study& study, const std::vector<Bisection>& bisections) {
  const auto all = combinations(study);
  std::vector<std::string> verdicts;
  for (std::size_t c = 0; c < bisections.size(); ++c) {
    if (bisections[c].found()) continue;
    const std::string said = bisections[c].verdict();
    const std::string verdict = said == "not yet" ? "a run ended neither well nor by diverging" : said;
    const auto overrides = overrides_of(study, all[c], {});
    verdicts.push_back(fmt::format("{}: {} from {} to {}: {}{}{}", study.decks[all[c].deck].file, study.vary.variable,
                                   study.interval.low, study.interval.high, verdict, overrides.empty() ? "" : ", with ",
                                   fmt::join(overrides, " ")));
  }
  return verdicts;
}

/// The columns that no run's history has, though some ended well: what wants them is a mistake that could not be
/// reported before. Where other runs have one, a missing cell says enough.
std::vector<std::string> lacking_columns(const Study& study, const std::vector<FinishedRun>& runs) {
  std::map<std::string, std::string> told;  // once a column
  for (const auto& wanted : study.history_values) {
    const auto& value = wanted.value;
    const auto has = [&](const FinishedRun& run) { return run.values.count(value.name()) > 0; };
    if (std::any_of(runs.begin(), runs.end(), has)) continue;
    for (const FinishedRun& run : runs) {
      if (const auto found = run.lacking.find(value.column); found != run.lacking.end()) told.insert(*found);
    }
  }
  std::vector<std::string> verdicts;
  verdicts.reserve(told.size());
  for (const auto& [column, hint] : told)
    verdicts.push_back(fmt::format("no run's history.txt has a column '{}'. {}", column, hint));
  return verdicts;
}

std::unique_ptr<FolderLock> lock_of_tables(const fs::path& out, const std::string& work) {
  constexpr std::chrono::minutes longest_wait(10);  // for others who write theirs
  return std::make_unique<FolderLock>(out / "runs", work, Sharing::alone, longest_wait);
}

/// What is stopped leaves nothing that is not its own.
void remove_earlier_results(const fs::path& folder) {
  for (const char* name :
       {"outcome.nc", "outcome.csv", "chart.nc", "chart.csv", "chart.txt", "map.nc", "map.csv", "map.txt"}) {
    std::error_code reason;
    fs::remove(folder / name, reason);
    if (reason) throw FileError(fmt::format("{}: cannot be removed: {}", (folder / name).string(), reason.message()));
  }
}

}  // namespace

std::unique_ptr<FolderLock> take_tables(const StudyOptions& options, const std::string& work) {
  if (options.doing == Doing::collect) return nullptr;  // has them since before it looked at what is finished
  return lock_of_tables(options.out, work);
}

std::unique_ptr<FolderLock> take_folder(const StudyOptions& options, const std::string& work) {
  if (options.doing == Doing::collect) return lock_of_tables(options.out, work);
  const Sharing sharing = options.doing == Doing::parts ? Sharing::together : Sharing::alone;
  auto lock =
      std::make_unique<FolderLock>(options.out, work, sharing);  // while a run of a killed study dies, it is taken
  if (sharing == Sharing::alone) remove_earlier_results(options.out);
  return lock;
}

void write_table(const fs::path& stem, const StudyTable& table, const Study& study, const std::string& command) {
  const auto file = [&stem](const char* ending) { return fs::path(stem).concat(ending); };
  write_netcdf(file(".nc"), table, {study.title, command, study.text, sha256(study.text), Units::none});
  replace_file(file(".csv"), csv_text(table));
}

std::size_t count_file_trouble(const std::vector<FinishedRun>& runs) {
  const auto in_trouble = [](const FinishedRun& run) { return is_lost(run.record.ending); };
  return static_cast<std::size_t>(std::count_if(runs.begin(), runs.end(), in_trouble));
}

void refuse_file_trouble(std::size_t runs, const std::string& first) {
  if (runs > 0)
    throw FileError(fmt::format(
        "runs that were killed, or could not read or write a file: {}; the same command tries them again{}{}", runs,
        first.empty() ? "" : "; the first says: ", first));
}

SweepResult report_study(const Study& study, const fs::path& out, const StudyOutcome& outcome,
                         const std::string& command) {
  const auto& runs = outcome.runs;
  const auto& bisections = outcome.sequences.bisections();
  const StudyTable table = run_table(study, runs);
  write_table(out / "table", table, study, command);
  SweepResult result{.report = report_text(study, table) + failures_text(runs),
                     .verdicts = outcome.is_whole ? broken_verdicts(study, bisections) : std::vector<std::string>{},
                     .file_trouble = count_file_trouble(runs)};
  for (auto& verdict : lacking_columns(study, runs)) result.verdicts.push_back(std::move(verdict));
  if (study.mode == Mode::grid) return result;
  const StudyTable summed_up =
      study.mode == Mode::ensemble ? ensemble_table(study, runs) : bisection_table(study, runs, bisections);
  write_table(out / "outcome", summed_up, study, command);
  result.report += fmt::format("\n{}", report_text(study, summed_up));
  return result;
}

SweepResult sweep(const Study& study, const StudyOptions& options) {
  const auto lock = take_folder(options, study.file);
  const std::vector<StudyRun> alone{{study, options.out}};
  const Scheduler::Outcome all = Scheduler(alone, options).run_all();
  const auto tables = take_tables(options, study.file);
  SweepResult result = report_study(study, options.out, all.studies.front(), options.command);
  result.signal = all.signal, result.unfinished = all.unfinished.size();
  return result;
}

std::string list_runs(const std::vector<StudyRun>& studies) {
  std::string text;
  for (const auto& [study, out, most_cpu_seconds] : studies) {
    const auto all = combinations(study);
    for (const Variant& variant : Sequences(study).first()) {
      const Combination& combination = all[variant.combination];
      const Deck deck = read_deck(study, combination, variant.varied);
      const std::string key = run_key(deck);
      const bool finished = read_record(run_folder(out, key), key).has_value();
      text += fmt::format("{} {} {}\n", finished ? "finished" : "to run  ", deck.file(),
                          fmt::join(overrides_of(study, combination, variant.varied), " "));
    }
  }
  return text;
}

}  // namespace tether
