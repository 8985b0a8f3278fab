// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <functional>

#include "base/diagnostics.hpp"
#include "base/process.hpp"
#include "base/text.hpp"
#include "cluster_commands.hpp"
#include "command_support.hpp"
#include "deck/document.hpp"
#include "deck/spelling.hpp"
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

std::string warnings_text(const std::string& name, const Loaded& loaded) {
  std::string text;
  for (const auto& warning : loaded.warnings) text += warning;
  for (const auto& warning : loaded.plan.warnings) text += fmt::format("{}: warning: {}\n", name, warning);
  return text;
}

/// One line for all remarks, so that what does no harm hides no warning; `where` says who reports them in full.
std::string remarks_text(const std::string& name, const Loaded& loaded, const std::string& where) {
  const auto count = loaded.remarks.size();
  return count == 0 ? "" : fmt::format("{}: {} remark{} {}\n", name, count, count == 1 ? "" : "s", where);
}

/// "DECK: remark", a line; empty for no remark.
std::string line_of(const std::string& name, const std::string& remark) {
  return remark.empty() ? "" : fmt::format("{}: {}\n", name, remark);
}

/// Returns whether the closing line names a key: what the run was for and what it can be trusted by.
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
std::string thin_bodies_text(const std::string& name, const Scene& scene) {
  const std::string thin = coupled::thin_text(scene);
  return thin.empty() ? "" : fmt::format("{}: warning: {}\n", name, thin);
}

std::string outcome_text(const std::string& name, const std::filesystem::path& folder, const Summary& summary) {
  std::string line = name + ":";
  for (const auto& [key, value] : summary) {
    if (key == "steps") line += fmt::format(" {} step{},", value, value == "1" ? "" : "s");
    if (closes_with(key, value)) line += fmt::format(" {} {:.4g},", key, std::stod(value));
  }
  line.back() = ' ';
  return fmt::format("{}in {}\n", line, folder.string());
}

/// Prints the plan with its own warnings, its cost as the first steps show it, and whether splitting would hold.
void print_plan(const Loaded& loaded) {
  const Plan& plan = loaded.plan;
  fmt::print("{}{}{}", to_text(rehearsed(plan)), regions_text(loaded.deck, plan.scene), coupled::splitting_text(plan));
}

/// Returns what is said before the first step.
std::string opening_text(const std::string& name, const Loaded& loaded, const RunOptions& options,
                         const std::filesystem::path& folder) {
  const std::string where = options.dry_run ? shown_by_check : "in " + (folder / "messages.txt").string();
  return line_of(name, threads_remark(loaded.plan, options.threads)) + warnings_text(name, loaded) +
         remarks_text(name, loaded, where);
}

/// Returns what the run hears of the command line and says back.
RunRequest request_for(const std::string& name, const Loaded& loaded, const std::filesystem::path& folder,
                       const RunOptions& options, ProgressLine& progress, Voice& voice) {
  RunRequest request = request_of(loaded, folder, options.command);
  if (const auto remark = threads_remark(loaded.plan, options.threads); !remark.empty())
    request.messages.push_back(remark);
  request.threads = threads_for(loaded.plan, options.threads);
  request.progress = std::ref(progress);
  request.warn = [&, name](const std::string& text) {
    progress.clear();
    voice.err(fmt::format("{}: warning: {}\n", name, text));
  };
  request.remark = [&, name](const std::string& text) { voice.err(fmt::format("{}: remark: {}\n", name, text)); };
  request.restart = options.restart;
  if (options.go_on) request.restart = newest_checkpoint(folder, request.deck_effective);
  if (options.go_on && request.restart.empty() && !checkpoints_in(folder).empty()) {
    request.messages.push_back(fmt::format(
        "{}: warning: no checkpoint in {} is whole and of this deck with these values: the run begins anew\n", name,
        folder.string()));
    voice.err(request.messages.back());
  }
  return request;
}

void run_deck(const std::string& name, const DeckOptions& options, const RunOptions& run_options, bool several,
              Voice& voice) {
  const Clocks clocks;
  Loaded loaded = load(name, options);
  const auto folder = folder_of(name, run_options, several);
  voice.err(opening_text(name, loaded, run_options, folder));
  if (run_options.slurm) return hand_over_run(name, loaded.plan.cost, folder, run_options);
  if (run_options.dry_run && !run_options.restart.empty()) checkpoint_for(run_options.restart, loaded.effective);
  if (run_options.dry_run) return print_plan(loaded);
  ProgressLine progress(name, run_options.quiet);
  RunRequest request = request_for(name, loaded, folder, run_options, progress, voice);
  request.clocks = clocks;
  SignalWatch signals;  // from here on there is something to be kept
  request.interrupted = [&signals] { return signals.take(); };
  const RunOutcome outcome = run(std::move(loaded.plan), request);
  progress.clear();
  voice.out(outcome_text(name, request.folder, outcome.summary));
  if (const int late = signals.take(); late != 0)
    throw Interrupted(late, "interrupted when the run had come to its end: its results are whole");
}

}  // namespace

int run_command(const std::vector<std::string>& decks, const DeckOptions& options, const RunOptions& run_options) {
  std::optional<Voice> voice;
  int worst = guarded("tether", [&] {
    refuse_shared_folders(decks, run_options);
    voice.emplace(run_options.log, run_options.quiet);
  });
  if (worst != exit_done) return worst;
  for (const auto& deck : decks) {
    const auto work = [&] { run_deck(deck, options, run_options, decks.size() > 1, *voice); };
    worst = std::max(worst, guarded(deck, work, &*voice));
    if (worst > exit_signal) break;
  }
  return worst;
}

int check_command(const std::string& name, const DeckOptions& options, bool all) {
  return guarded(name, [&] {
    Diagnostics diagnostics;
    const Deck deck = load_deck(name, options, diagnostics);
    fmt::print("{}", check_listing(deck, {all, isatty(STDOUT_FILENO) != 0}));
    std::fflush(stdout);  // the values first, then what is to be said of them
    const Loaded loaded = load_scene(deck, options, diagnostics);
    fmt::print("{}", regions_text(loaded.deck, loaded.plan.scene));
    std::fflush(stdout);
    for (const auto& remark : loaded.remarks) fmt::print(stderr, "{}", remark);
    fmt::print(stderr, "{}{}", warnings_text(name, loaded), thin_bodies_text(name, loaded.plan.scene));
  });
}

int plan_command(const std::string& deck, const DeckOptions& options, int threads) {
  return guarded(deck, [&] {
    const Loaded loaded = load(deck, options);
    std::string text = line_of(deck, threads_remark(loaded.plan, threads));
    for (const auto& warning : loaded.warnings) text += warning;
    text += thin_bodies_text(deck, loaded.plan.scene) + remarks_text(deck, loaded, shown_by_check);
    fmt::print(stderr, "{}", text);
    print_plan(loaded);
  });
}

int vars_command(const std::string& group, bool markdown) {
  return guarded("tether vars", [&] {
    const std::string listing = markdown ? variables_markdown(lower(group)) : variables_listing(lower(group));
    if (listing.empty())
      throw InputError(fmt::format("there is no group {}", in_quotes("$" + group)),
                       suggest_group(group) + " tether vars lists all.");
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
