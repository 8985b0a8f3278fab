// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <functional>

#include "base/diagnostics.hpp"
#include "base/process.hpp"
#include "base/text.hpp"
#include "command_support.hpp"
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

namespace tether {
namespace {

const std::string shown_by_check = "shown by tether check";

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

int vars_command(const std::string& group, bool markdown) {
  return guarded("tether vars", [&] {
    const std::string listing = markdown ? variables_markdown(lower(group)) : variables_listing(lower(group));
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
