// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/runs/run_task.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/resource.h>
#include <algorithm>
#include <cmath>
#include <csignal>
#include <map>

#include "base/diagnostics.hpp"
#include "base/letters.hpp"
#include "base/numbers.hpp"
#include "deck/reader.hpp"
#include "results/checkpoint.hpp"
#include "results/summary_keys.hpp"
#include "run/make.hpp"
#include "run/run.hpp"
#include "studies/runs/read_run.hpp"

namespace tether {
namespace {

/// Limits what this process, and each one that it starts, may take of the processor: the kernel ends one that takes
/// more. Whole seconds, rounded up.
void limit_cpu(double seconds) {
  if (!std::isfinite(seconds)) return;
  const auto whole = static_cast<rlim_t>(std::max(1., std::ceil(seconds)));
  const rlimit limit{whole, whole + 1};
  setrlimit(RLIMIT_CPU, &limit);
}

/// A run that went on from a checkpoint has cost more than its last process: its summary knows.
void count_earlier_cost(RunRecord& record, const std::filesystem::path& folder) {
  if (record.ending.exit_code != exit_done) return;
  const auto numbers = summary_numbers(folder / "summary.txt");
  record.cpu_seconds = std::max(record.cpu_seconds, numbers.at("cpu_seconds"));
  record.wall_seconds = std::max(record.wall_seconds, numbers.at("wall_seconds"));
}

}  // namespace

Ending do_run(const RunTask& task) {
  limit_cpu(task.most_cpu_seconds);
  const Clocks clocks;
  SignalWatch watch;
  std::string warnings;
  const auto warn = [&warnings](const std::string& text) { warnings += "warning: " + text + "\n"; };
  const Ending ending = end_of(task.deck, [&] {
    Diagnostics of_the_deck, diagnostics;
    const Deck deck = read_deck(task.text, task.deck, task.overrides, of_the_deck);
    Loaded loaded = load_scene(deck, {}, diagnostics);
    RunRequest request = request_of(loaded, task.folder, command_of(task));
    request.clocks = clocks;
    request.threads = threads_for(loaded.plan, task.threads);
    request.restart = newest_checkpoint(task.folder, request.deck_effective);
    request.interrupted = [&watch] { return watch.take(); };
    request.warn = warn;
    for (const auto& warning : loaded.warnings) {
      if (warning.starts_with(override_file)) warnings += warning;  // of what the study sets
    }
    for (const auto& warning : loaded.plan.warnings) warn(warning);
    run(std::move(loaded.plan), request);
  });
  return ending.exit_code == exit_done ? Ending{exit_done, warnings} : ending;
}

Cost expected_cost(const Deck& deck) {
  Cost cost;
  end_of(deck.file(), [&] {
    Diagnostics diagnostics;
    cost = load_scene(deck, {}, diagnostics).plan.cost;
  });
  return cost;
}

RunRecord record_end(const RunTask& task, const Finished& process) {
  RunRecord record{task.key, process.ending, process.cpu_seconds, process.wall_seconds};
  record.ending.message = one_line(record.ending.message);
  count_earlier_cost(record, task.folder);
  if (!is_lost(record.ending)) write_record(task.folder, record);
  return record;
}

std::string text_of(const RunTask& task) {
  return Packed()
      .add(task.deck)
      .add(task.text)
      .add(task.overrides)
      .add(task.key)
      .add(task.folder.string())
      .add(task.sign.string())
      .add(task.threads)
      .add(task.most_cpu_seconds)
      .text();
}

RunTask task_of(const std::string& text) {
  Packed parts(text);
  RunTask task;
  task.deck = parts.take_text(), task.text = parts.take_text(), task.overrides = parts.take_texts();
  task.key = parts.take_text(), task.folder = parts.take_text(), task.sign = parts.take_text();
  task.threads = static_cast<int>(parts.take_number()), task.most_cpu_seconds = parts.take_number();
  return task;
}

std::string text_of(const RunRecord& record) {
  const auto& [key, ending, cpu_seconds, wall_seconds] = record;
  const std::string failure(ending.failure ? word_of(*ending.failure) : "");
  return Packed()
      .add(key)
      .add(ending.exit_code)
      .add(ending.message)
      .add(failure)
      .add(cpu_seconds)
      .add(wall_seconds)
      .text();
}

RunRecord record_of(const std::string& text) {
  Packed parts(text);
  RunRecord record;
  record.key = parts.take_text();
  record.ending.exit_code = static_cast<int>(parts.take_number()), record.ending.message = parts.take_text();
  record.ending.failure = find_word<Failure>(parts.take_text());
  record.cpu_seconds = parts.take_number(), record.wall_seconds = parts.take_number();
  return record;
}

std::string command_of(const RunTask& task) {
  const auto& overrides = task.overrides;
  return fmt::format("tether {}{}{}", task.deck, overrides.empty() ? "" : " --set ", fmt::join(overrides, " --set "));
}

}  // namespace tether
