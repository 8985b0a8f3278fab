// SPDX-License-Identifier: GPL-3.0-or-later
#include "study_commands.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>

#include "base/diagnostics.hpp"
#include "base/process.hpp"
#include "command_support.hpp"
#include "commands.hpp"
#include "progress.hpp"
#include "shared_files.hpp"
#include "studies/automatic/find_setting.hpp"
#include "studies/chart/make_chart.hpp"
#include "studies/chart/read_chart.hpp"
#include "studies/map/make_map.hpp"
#include "studies/map/read_map.hpp"
#include "studies/read_study.hpp"
#include "studies/reproduce/reproduce.hpp"
#include "studies/runs/local_crew.hpp"
#include "studies/runs/remote_crew.hpp"
#include "studies/sweep.hpp"

namespace tether {
namespace {

void refuse_file_trouble(std::size_t runs) {
  if (runs > 0)
    throw FileError(fmt::format("{} runs could not read or write a file; the same command tries them again", runs));
}

void refuse_interruption(int signal, const std::filesystem::path& folder) {
  if (signal != 0)
    throw Interrupted(signal,
                      fmt::format("interrupted; the same command goes on, finished runs are in {}", folder.string()));
}

/// Who does the runs: the other programs of this command, where mpirun has started some, else processes of this one.
std::unique_ptr<Crew> crew_of(const RunOptions& options) {
  if (options.others == nullptr) return std::make_unique<LocalCrew>(options.jobs);
  return std::make_unique<RemoteCrew>(*options.others, options.count_others);
}

/// How a study is to be run by a crew, as far as the command line says.
StudyOptions study_options(const std::filesystem::path& folder, Crew& crew, const RunOptions& options,
                           ProgressLine& progress) {
  return {.out = folder,
          .crew = crew,
          .threads = options.threads,
          .command = options.command,
          .progress = std::ref(progress)};
}

/// False where a bisection found nothing.
bool run_sweep(const std::string& name, const RunOptions& options) {
  const Study study = read_study(name);
  const auto folder = folder_of(name, options, false);
  if (options.dry_run) return fmt::print("{}", list_runs(study, folder)), true;
  ProgressLine progress(name, options.quiet);
  const auto crew = crew_of(options);
  const SweepResult result = sweep(study, study_options(folder, *crew, options, progress));
  progress.clear();
  if (!options.quiet) fmt::print("{}", result.report);
  for (const auto& verdict : result.verdicts) fmt::print(stderr, "{}: error: {}\n", name, verdict);
  refuse_interruption(result.signal, folder);
  refuse_file_trouble(result.file_trouble);
  return result.verdicts.empty();
}

/// What is left to do of a study that was read, in a folder. False where it did not come out well.
using Work = std::function<bool(const std::filesystem::path& folder)>;
using ReadStudy = std::function<Work(const std::string& name, const RunOptions& options)>;

/// Its work is false where a run did not end well, or none has an error.
Work chart_work(const std::string& name, const RunOptions& options) {
  return [name, &options, chart = chart::read_chart(name)](const std::filesystem::path& folder) {
    if (options.dry_run) return fmt::print("{}", list_chart_runs(chart, folder)), true;
    ProgressLine progress(name, options.quiet);
    const auto crew = crew_of(options);
    const chart::ChartResult result = make_chart(chart, study_options(folder, *crew, options, progress));
    progress.clear();
    if (!options.quiet) fmt::print("{}", result.report);
    refuse_file_trouble(result.file_trouble);
    return result.failed == 0 && !result.shows_nothing;
  };
}

/// Its work is false where a run says nothing.
Work map_work(const std::string& name, const RunOptions& options) {
  return [name, &options, map = map::read_map(name)](const std::filesystem::path& folder) {
    if (options.dry_run) return fmt::print("{}", list_runs(map.study, folder)), true;
    ProgressLine progress(name, options.quiet);
    const auto crew = crew_of(options);
    const map::MapResult result = make_map(map, study_options(folder, *crew, options, progress));
    progress.clear();
    if (!options.quiet) fmt::print("{}", result.report);
    refuse_interruption(result.signal, folder);
    refuse_file_trouble(result.file_trouble);
    return result.telling_nothing == 0;
  };
}

/// All are read before the first is made. Each goes to a folder of its own, by default below `parent`.
int make_each(const std::vector<std::string>& names, RunOptions options, const std::filesystem::path& parent,
              const ReadStudy& read) {
  const bool several = names.size() > 1 || options.out.empty();
  if (options.out.empty()) options.out = parent;
  int worst = guarded("tether", [&] { refuse_shared_folders(names, options); });
  std::vector<Work> all(names.size());
  for (std::size_t k = 0; k < names.size(); ++k)
    worst = std::max(worst, guarded(names[k], [&] { all[k] = read(names[k], options); }));
  if (worst != exit_done) return worst;
  for (std::size_t k = 0; k < names.size() && worst < exit_signal; ++k) {
    bool good = true;
    const int code = guarded(names[k], [&] { good = all[k](folder_of(names[k], options, several)); });
    worst = std::max(worst, code == exit_done && !good ? exit_verdict : code);
  }
  return worst;
}

/// Puts what the chosen run wrote where a run of the deck writes.
void take_over(const std::filesystem::path& run, const std::filesystem::path& folder) {
  std::error_code reason;
  std::filesystem::copy(run, folder,
                        std::filesystem::copy_options::recursive | std::filesystem::copy_options::overwrite_existing,
                        reason);
  if (reason)
    throw FileError(
        fmt::format("{}: its files cannot be copied to {}: {}", run.string(), folder.string(), reason.message()));
}

/// What was found; its folder is empty where nothing can be promised.
automatic::Found find(const std::string& name, const automatic::Automatic& wanted, const RunOptions& options,
                      const std::filesystem::path& folder) {
  ProgressLine progress(name, options.quiet);
  const auto crew = crew_of(options);
  const automatic::Found found = automatic::find_setting(wanted, study_options(folder, *crew, options, progress));
  progress.clear();
  if (!options.quiet) fmt::print("{}", found.report);
  if (found.folder.empty()) fmt::print(stderr, "{}: error: cannot promise: {}\n", name, found.why_not);
  return found;
}

/// False where nothing can be promised.
bool run_automatic(const std::string& name, const automatic::Automatic& wanted, const RunOptions& options,
                   const std::filesystem::path& folder) {
  if (options.dry_run) return fmt::print("{}", list_first_runs(wanted, folder)), true;
  const automatic::Found found = find(name, wanted, options, folder);
  if (found.folder.empty()) return false;
  take_over(found.folder, folder);
  if (!options.quiet) fmt::print("{}: the chosen run, in {}\n", name, folder.string());
  return true;
}

std::string decks_of(const PublishedOptions& published) {
  if (!published.decks.empty()) return published.decks;
  return std::filesystem::is_directory("decks") ? "decks" : (shared_folder() / "decks").string();
}

/// False where a method does not agree where it is judged.
bool run_published(const PublishedOptions& published, const RunOptions& options) {
  ProgressLine progress("reproduce", options.quiet);
  const std::filesystem::path out = options.out.empty() ? "out/reproduce" : options.out;
  const auto crew = crew_of(options);
  const ReproduceOptions how{decks_of(published), published.write, study_options(out, *crew, options, progress)};
  if (options.dry_run) return fmt::print("{}", list_published_runs(published.names, how)), true;
  const ReproduceResult result = reproduce(published.names, how);
  progress.clear();
  if (!options.quiet) fmt::print("{}", result.report);
  for (const auto& row : result.disagreed) fmt::print(stderr, "reproduce: error: {}\n", row);
  refuse_file_trouble(result.file_trouble);
  return result.disagreed.empty();
}

}  // namespace

int sweep_command(const std::string& name, const RunOptions& options) {
  bool all_found = true;
  const int code = guarded(name, [&] { all_found = run_sweep(name, options); });
  return code == exit_done && !all_found ? exit_verdict : code;
}

int chart_command(const std::vector<std::string>& studies, const RunOptions& options) {
  return make_each(studies, options, "out/charts", chart_work);
}

int map_command(const std::vector<std::string>& studies, const RunOptions& options) {
  return make_each(studies, options, "out/maps", map_work);
}

int auto_command(const std::vector<std::string>& names, const DeckOptions& deck_options, const RunOptions& options) {
  const ReadStudy read = [&deck_options](const std::string& name, const RunOptions& run_options) -> Work {
    return [name, &run_options, wanted = automatic::read_automatic(name, deck_options, *run_options.tolerance)](
               const auto& folder) { return run_automatic(name, wanted, run_options, folder); };
  };
  return make_each(names, options, "out", read);
}

int auto_plan_command(const std::string& name, const DeckOptions& deck_options, const RunOptions& options) {
  std::filesystem::path chosen;
  const int code = guarded(name, [&] {
    const auto wanted = automatic::read_automatic(name, deck_options, *options.tolerance);
    const auto folder = folder_of(name, options, false);
    if (!find(name, wanted, options, folder).folder.empty()) chosen = folder / automatic::chosen_deck;
  });
  if (code != exit_done) return code;
  return chosen.empty() ? exit_verdict : plan_command(chosen.string(), {}, options.threads);
}

int reproduce_command(const PublishedOptions& published, const RunOptions& options) {
  bool all_agree = true;
  const int code = guarded("reproduce", [&] { all_agree = run_published(published, options); });
  return code == exit_done && !all_agree ? exit_verdict : code;
}

}  // namespace tether
