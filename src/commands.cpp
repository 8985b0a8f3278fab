// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <set>

#include "base/diagnostics.hpp"
#include "base/process.hpp"
#include "base/text.hpp"
#include "deck/document.hpp"
#include "physics/box/bodies.hpp"
#include "physics/box/splitting_limit.hpp"
#include "plan/plan_text.hpp"
#include "progress.hpp"
#include "read/points/region_checks.hpp"
#include "results/summary_keys.hpp"
#include "run/make.hpp"
#include "run/rehearsal.hpp"
#include "run/restart.hpp"
#include "run/run.hpp"
#include "studies/chart/make_chart.hpp"
#include "studies/chart/read_chart.hpp"
#include "studies/read_study.hpp"
#include "studies/reproduce/reproduce.hpp"
#include "studies/sweep.hpp"

namespace tether {
namespace {

const std::string shown_by_check = "shown by tether check";

/// Runs the command, tells on stderr what went wrong, and returns the exit code.
int guarded(const std::string& name, const std::function<void()>& command) {
  const Ending ending = end_of(name, [&command] {
    command();
    if (std::fflush(stdout) != 0) throw FileError("the standard output takes no more text");
  });
  std::fputs(ending.message.c_str(), stderr);  // nowhere to tell of it where this fails
  return ending.exit_code;
}

std::string deck_name(const std::string& deck) { return std::filesystem::path(deck).stem().string(); }

/// One deck's own folder: DIR for a single deck, DIR/<deck name> for several, out/<deck name> without --out.
std::filesystem::path folder_of(const std::string& deck, const RunOptions& options, bool several) {
  const std::filesystem::path out = options.out.empty() ? "out" : options.out;
  return options.out.empty() || several ? out / deck_name(deck) : out;
}

/// Nobody is to wait for threads that nothing uses; empty where none were asked for, or some do.
std::string threads_remark(const Plan& plan, int threads) {
  if (threads <= 1 || shares_work(plan)) return "";
  return fmt::format(
      "remark: --threads {} changes nothing: this path computes with one thread; several runs go side by side by "
      "tether sweep --jobs",
      threads);
}

void print_threads_remark(const std::string& name, const Plan& plan, int threads) {
  if (const auto remark = threads_remark(plan, threads); !remark.empty()) fmt::print(stderr, "{}: {}\n", name, remark);
}

void print_warnings(const std::string& name, const Loaded& loaded) {
  for (const auto& warning : loaded.warnings) fmt::print(stderr, "{}", warning);
  for (const auto& warning : loaded.plan.warnings) fmt::print(stderr, "{}: warning: {}\n", name, warning);
}

/// What does no harm is one line, so that it hides no warning; `where` says who tells all of it.
void print_number_of_remarks(const std::string& name, const Loaded& loaded, const std::string& where) {
  const auto count = loaded.remarks.size();
  if (count > 0) fmt::print(stderr, "{}: {} remark{} {}\n", name, count, count == 1 ? "" : "s", where);
}

/// Whether the closing line names a key: what the run was for and what it can be trusted by.
bool closes_with(const std::string& key, const std::string& value) {
  constexpr std::array names{"cpu_seconds",          "period",
                             "momentum_drift",       "angular_momentum_drift",
                             "energy_drift",         "interface_mismatch",
                             "equilibrium_residual", "steady_residual"};
  if (std::find(names.begin(), names.end(), key) != names.end()) return true;
  if (key == "energy_lost") return value != "0";
  return key.starts_with("error_") || key.starts_with("drag_") || key.starts_with("lift_");
}

/// Warns of bodies too thin for the cells where they stand at the start, as a run does, too.
void print_thin_bodies(const std::string& name, const Scene& scene) {
  const std::string thin = coupled::thin_text(scene);
  if (!thin.empty()) fmt::print(stderr, "{}: warning: {}\n", name, thin);
}

void print_outcome(const std::string& name, const std::filesystem::path& folder, const Summary& summary) {
  std::string line = name + ":";
  for (const auto& [key, value] : summary) {
    if (key == "steps") line += fmt::format(" {} step{},", value, value == "1" ? "" : "s");
    if (closes_with(key, value)) line += fmt::format(" {} {:.4g},", key, std::stod(value));
  }
  line.back() = ' ';
  fmt::print("{}in {}\n", line, folder.string());
}

/// With its own warnings, its cost as the first steps show it, and whether splitting would hold.
void print_plan(const Loaded& loaded) {
  const Plan& plan = loaded.plan;
  fmt::print("{}{}{}", to_text(rehearsed(plan)), regions_text(loaded.deck, plan.scene), coupled::splitting_text(plan));
}

void run_deck(const std::string& name, const DeckOptions& options, const RunOptions& run_options, bool several) {
  const Clocks clocks;
  Loaded loaded = load(name, options);
  const auto folder = folder_of(name, run_options, several);
  if (!run_options.quiet) {
    print_threads_remark(name, loaded.plan, run_options.threads);
    print_warnings(name, loaded);
    print_number_of_remarks(name, loaded,
                            run_options.dry_run ? shown_by_check : "in " + (folder / "messages.txt").string());
  }
  if (run_options.dry_run && !run_options.restart.empty()) checkpoint_for(run_options.restart, loaded.effective);
  if (run_options.dry_run) return print_plan(loaded);
  ProgressLine progress(name, run_options.quiet);
  const auto warn = [&](const std::string& text) {
    progress.clear();
    if (!run_options.quiet) fmt::print(stderr, "{}: warning: {}\n", name, text);
  };
  RunRequest request = request_of(loaded, folder, run_options.command);
  if (const auto remark = threads_remark(loaded.plan, run_options.threads); !remark.empty())
    request.messages.push_back(remark);
  request.threads = threads_for(loaded.plan, run_options.threads);
  request.clocks = clocks;
  request.progress = std::ref(progress);
  request.warn = warn;
  request.remark = [&](const std::string& text) {
    if (!run_options.quiet) fmt::print(stderr, "{}: remark: {}\n", name, text);
  };
  SignalWatch signals;  // from here on there is something to be kept
  request.interrupted = [&signals] { return signals.take(); };
  request.restart = run_options.restart;
  const RunOutcome outcome = run(std::move(loaded.plan), request);
  progress.clear();
  if (!run_options.quiet) print_outcome(name, request.folder, outcome.summary);
  if (const int late = signals.take(); late != 0)
    throw Interrupted(late, "interrupted when the run had come to its end: its results are whole");
}

/// Two decks of one name would write into one folder; a checkpoint is of one deck.
void refuse_shared_folders(const std::vector<std::string>& decks, const RunOptions& options) {
  if (decks.size() > 1 && !options.restart.empty()) {
    throw InputError("--restart goes with one deck, the checkpoint's", "run the others by themselves");
  }
  std::set<std::string> names;
  for (const auto& deck : decks) {
    if (!names.insert(deck_name(deck)).second) {
      throw InputError(fmt::format("two decks are named {} and would write into one folder", deck_name(deck)),
                       "run them one by one, each with its own --out");
    }
  }
}

void refuse_file_trouble(std::size_t runs) {
  if (runs > 0)
    throw FileError(fmt::format("{} runs could not read or write a file; the same command tries them again", runs));
}

/// False where a bisection found nothing.
bool run_sweep(const std::string& name, const RunOptions& options) {
  const Study study = read_study(name);
  const auto folder = folder_of(name, options, false);
  if (options.dry_run) return fmt::print("{}", list_runs(study, folder)), true;
  ProgressLine progress(name, options.quiet);
  const SweepResult result = sweep(study, {folder, options.jobs, options.threads, options.command, std::ref(progress)});
  progress.clear();
  if (!options.quiet) fmt::print("{}", result.report);
  for (const auto& verdict : result.verdicts) fmt::print(stderr, "{}: error: {}\n", name, verdict);
  if (result.signal != 0)
    throw Interrupted(result.signal,
                      fmt::format("interrupted; the same command goes on, finished runs are in {}", folder.string()));
  refuse_file_trouble(result.file_trouble);
  return result.verdicts.empty();
}

/// False where a run did not end well.
bool run_chart(const std::string& name, const RunOptions& options) {
  const chart::Chart chart = chart::read_chart(name);
  const auto folder = folder_of(name, options, false);
  if (options.dry_run) return fmt::print("{}", list_chart_runs(chart, folder)), true;
  ProgressLine progress(name, options.quiet);
  const chart::ChartResult result =
      make_chart(chart, {folder, {options.jobs, options.threads}, options.command, std::ref(progress)});
  progress.clear();
  if (!options.quiet) fmt::print("{}", result.report);
  refuse_file_trouble(result.file_trouble);
  return result.failed == 0;
}

/// False where a method does not agree where it is judged.
bool run_published(const PublishedOptions& published, const RunOptions& options) {
  ProgressLine progress("reproduce", options.quiet);
  const std::filesystem::path out = options.out.empty() ? "out/reproduce" : options.out;
  const ReproduceOptions how{published.decks,   out, published.write, options.jobs, options.threads, options.command,
                             std::ref(progress)};
  if (options.dry_run) return fmt::print("{}", list_published_runs(published.names, how)), true;
  const ReproduceResult result = reproduce(published.names, how);
  progress.clear();
  if (!options.quiet) fmt::print("{}", result.report);
  for (const auto& row : result.disagreed) fmt::print(stderr, "reproduce: error: {}\n", row);
  refuse_file_trouble(result.file_trouble);
  return result.disagreed.empty();
}

}  // namespace

int run_command(const std::vector<std::string>& decks, const DeckOptions& options, const RunOptions& run_options) {
  int worst = guarded("tether", [&] { refuse_shared_folders(decks, run_options); });
  if (worst != exit_done) return worst;
  for (const auto& deck : decks) {
    worst = std::max(worst, guarded(deck, [&] { run_deck(deck, options, run_options, decks.size() > 1); }));
    if (worst > exit_signal) break;
  }
  return worst;
}

int check_command(const std::string& name, const DeckOptions& options) {
  return guarded(name, [&] {
    Diagnostics diagnostics;
    const Deck deck = load_deck(name, options, diagnostics);
    fmt::print("{}", check_listing(deck));
    std::fflush(stdout);  // the values first, then what is to be said of them
    const Loaded loaded = load_scene(deck, options, diagnostics);
    fmt::print("{}", regions_text(loaded.deck, loaded.plan.scene));
    std::fflush(stdout);
    for (const auto& remark : loaded.remarks) fmt::print(stderr, "{}", remark);
    print_warnings(name, loaded);
    print_thin_bodies(name, loaded.plan.scene);
  });
}

int plan_command(const std::string& deck, const DeckOptions& options, int threads) {
  return guarded(deck, [&] {
    const Loaded loaded = load(deck, options);
    print_threads_remark(deck, loaded.plan, threads);
    for (const auto& warning : loaded.warnings) fmt::print(stderr, "{}", warning);
    print_thin_bodies(deck, loaded.plan.scene);
    print_number_of_remarks(deck, loaded, shown_by_check);
    print_plan(loaded);
  });
}

int sweep_command(const std::string& name, const RunOptions& options) {
  bool all_found = true;
  const int code = guarded(name, [&] { all_found = run_sweep(name, options); });
  return code == exit_done && !all_found ? exit_verdict : code;
}

int chart_command(const std::string& name, const RunOptions& options) {
  bool all_ended = true;
  const int code = guarded(name, [&] { all_ended = run_chart(name, options); });
  return code == exit_done && !all_ended ? exit_verdict : code;
}

int reproduce_command(const PublishedOptions& published, const RunOptions& options) {
  bool all_agree = true;
  const int code = guarded("reproduce", [&] { all_agree = run_published(published, options); });
  return code == exit_done && !all_agree ? exit_verdict : code;
}

int vars_command(const std::string& group, bool markdown) {
  return guarded("tether vars", [&] {
    const std::string listing = markdown ? variables_markdown() : variables_listing(lower(group));
    if (listing.empty()) throw InputError(fmt::format("there is no group {}", group), "tether vars lists all");
    fmt::print("{}", listing);
  });
}

int columns_command(bool markdown) {
  return guarded("tether columns", [&] {
    const auto all = columns_of_all_physics();
    fmt::print("{}", markdown ? columns_markdown(all) : columns_listing(all));
  });
}

int keys_command(bool markdown) {
  return guarded("tether keys", [&] { fmt::print("{}", markdown ? keys_markdown() : keys_listing()); });
}

}  // namespace tether
