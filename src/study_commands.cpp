// SPDX-License-Identifier: GPL-3.0-or-later
#include "study_commands.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <functional>

#include "base/diagnostics.hpp"
#include "base/process.hpp"
#include "cluster_commands.hpp"
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
#include "studies/runs/parts.hpp"
#include "studies/sweep.hpp"

namespace tether {
namespace {

void refuse_interruption(int signal, const std::filesystem::path& folder) {
  if (signal != 0)
    throw Interrupted(signal,
                      fmt::format("interrupted; the same command goes on, finished runs are in {}", folder.string()));
}

/// What the command line says of the runs of studies, who does them (the other programs of this command, where mpirun
/// has started some, else processes of this one), and the line that says how far they are.
class Making {
 public:
  Making(const std::string& name, const std::filesystem::path& folder, const RunOptions& options)
      : progress_(name, options.quiet),
        crew_(options.jobs),
        how_{.out = folder,
             .crew = options.others == nullptr ? crew_ : *options.others,
             .threads = options.threads,
             .command = options.command,
             .progress = std::ref(progress_)} {
    if (options.collect) how_.doing = Doing::collect;
    if (!options.parts.empty()) how_.doing = Doing::parts, how_.parts = part_numbers(options.parts).value();
  }

  const StudyOptions& how() const { return how_; }
  ProgressLine& progress() { return progress_; }

 private:
  ProgressLine progress_;
  LocalCrew crew_;
  StudyOptions how_;
};

/// False where some parts that were to be collected are not finished; says so.
bool is_whole(const std::string& name, std::size_t unfinished) {
  if (unfinished > 0) fmt::print(stderr, "{}: parts that are not finished: {}; --list shows them\n", name, unfinished);
  return unfinished == 0;
}

/// False where a bisection found nothing.
bool run_sweep(const std::string& name, const RunOptions& options) {
  const Study study = read_study(name);
  const auto folder = folder_of(name, options, false);
  Making making(name, folder, options);
  const auto runs = [&] { return std::vector<StudyRun>{{study, folder}}; };
  if (is_done_otherwise(name, runs, making.how(), options)) return true;
  const SweepResult result = sweep(study, making.how());
  making.progress().clear();
  if (!options.quiet) fmt::print("{}", result.report);
  for (const auto& verdict : result.verdicts) fmt::print(stderr, "{}: error: {}\n", name, verdict);
  refuse_interruption(result.signal, folder);
  refuse_file_trouble(result.file_trouble);
  return is_whole(name, result.unfinished) && result.verdicts.empty();
}

/// What is left to do of a study that was read, in a folder. False where it did not come out well.
using Work = std::function<bool(const std::filesystem::path& folder)>;
using ReadStudy = std::function<Work(const std::string& name, const RunOptions& options)>;

/// Its work is false where a run did not end well, or none has an error.
Work chart_work(const std::string& name, const RunOptions& options) {
  return [name, &options, chart = chart::read_chart(name)](const std::filesystem::path& folder) {
    Making making(name, folder, options);
    const auto runs = [&] { return study_runs_of(chart, folder); };
    if (is_done_otherwise(name, runs, making.how(), options)) return true;
    const chart::ChartResult result = make_chart(chart, making.how());
    making.progress().clear();
    if (!options.quiet) fmt::print("{}", result.report);
    refuse_file_trouble(result.file_trouble);
    return is_whole(name, result.unfinished) && result.failed == 0 && !result.shows_nothing;
  };
}

/// Its work is false where a run says nothing.
Work map_work(const std::string& name, const RunOptions& options) {
  return [name, &options, map = map::read_map(name)](const std::filesystem::path& folder) {
    Making making(name, folder, options);
    const auto runs = [&] { return std::vector<StudyRun>{{map.study, folder}}; };
    if (is_done_otherwise(name, runs, making.how(), options)) return true;
    const map::MapResult result = make_map(map, making.how());
    making.progress().clear();
    if (!options.quiet) fmt::print("{}", result.report);
    refuse_interruption(result.signal, folder);
    refuse_file_trouble(result.file_trouble);
    return is_whole(name, result.unfinished) && result.telling_nothing == 0;
  };
}

/// All are read before the first is made. Each goes to a folder of its own, by default below `parent`.
int make_each(const std::vector<std::string>& names, RunOptions options, const std::filesystem::path& parent,
              const ReadStudy& read) {
  const bool several = names.size() > 1 || options.out.empty();
  if (options.out.empty()) options.out = parent;
  int worst = guarded("tether", [&] {
    refuse_shared_folders(names, options);
    refuse_parts_of_several(names, options);
  });
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
  Making making(name, folder, options);
  const automatic::Found found = automatic::find_setting(wanted, making.how());
  making.progress().clear();
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
  const std::filesystem::path out = options.out.empty() ? "out/reproduce" : options.out;
  Making making("reproduce", out, options);
  const ReproduceOptions how{decks_of(published), published.write, making.how()};
  const auto runs = [&] { return published_runs(published.names, how); };
  if (is_done_otherwise("reproduce", runs, how.study, options)) return true;
  const ReproduceResult result = reproduce(published.names, how);
  making.progress().clear();
  if (!options.quiet) fmt::print("{}", result.report);
  for (const auto& row : result.disagreed) fmt::print(stderr, "reproduce: error: {}\n", row);
  refuse_file_trouble(result.file_trouble);
  return is_whole("reproduce", result.unfinished) && result.disagreed.empty();
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
