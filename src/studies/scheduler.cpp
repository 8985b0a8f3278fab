// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/scheduler.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <tuple>

#include "base/child.hpp"
#include "base/diagnostics.hpp"
#include "base/numbers.hpp"
#include "results/checkpoint.hpp"
#include "results/summary_keys.hpp"
#include "run/make.hpp"
#include "run/run.hpp"

namespace tether {
namespace {

/// What a pipe takes without anyone reading, on any system: messages are cut to it.
constexpr std::size_t longest_message = 4096;

std::string killed_text(int signal) {
  if (signal == SIGXCPU) return "stopped: it has taken as much of the processor as it may\n";
  return fmt::format("killed by signal {}\n", signal);
}

[[noreturn]] void work_and_exit(pid_t parent, int pipe_end, const std::function<Ending()>& work) {
  if (!end_with_parent(parent)) _exit(exit_signal + SIGKILL);
  const Ending ending = work();
  const std::string text = fmt::format("{}\n{}", ending.failure ? word_of(*ending.failure) : "", ending.message);
  const auto written = write(pipe_end, text.data(), std::min(text.size(), longest_message));
  _exit(written < 0 ? exit_file : ending.exit_code);
}

/// How a process ended that says so through its pipe: the failure in the first line, then the message.
Ending read_ending(int pipe_end, int exit_code) {
  std::array<char, longest_message> chars{};
  const auto length = read(pipe_end, chars.data(), chars.size());
  const std::string text(chars.data(), static_cast<std::size_t>(std::max(length, ssize_t{0})));
  const auto end = text.find('\n');
  if (end == std::string::npos) return {exit_code, text};
  return {exit_code, text.substr(end + 1), find_word<Failure>(text.substr(0, end))};
}

}  // namespace

Workers::~Workers() {
  tell(SIGKILL);
  for (const auto& [id, process] : running_) {
    waitpid(process.pid, nullptr, 0);
    close(process.message);
  }
}

void Workers::start(std::size_t id, const std::function<Ending()>& work) {
  std::array<int, 2> ends{};
  const pid_t parent = getpid();
  if (pipe(ends.data()) != 0) throw FileError(fmt::format("no process can be started: {}", std::strerror(errno)));
  const auto start = std::chrono::steady_clock::now();
  const pid_t pid = fork();
  if (pid == 0) work_and_exit(parent, ends[1], work);
  const int reason = errno;
  close(ends[1]);
  if (pid > 0) {
    running_[id] = {pid, ends[0], start};
    return;
  }
  close(ends[0]);
  throw FileError(fmt::format("no process can be started: {}", std::strerror(reason)));
}

std::optional<Finished> Workers::take() {
  for (const auto& [id, process] : running_) {
    int status = 0;
    rusage usage{};
    if (wait4(process.pid, &status, WNOHANG, &usage) != process.pid) continue;
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - process.start;
    Finished finished{id, {}, processor_seconds(usage), wall.count()};
    if (WIFSIGNALED(status))
      finished.ending = {exit_signal + WTERMSIG(status), killed_text(WTERMSIG(status))};
    else
      finished.ending = read_ending(process.message, WEXITSTATUS(status));
    close(process.message);
    running_.erase(id);
    return finished;
  }
  return std::nullopt;
}

void Workers::tell(int signal) const {
  for (const auto& [id, process] : running_) kill(process.pid, signal);
}

namespace {

std::map<std::string, double> numbers_of(const std::filesystem::path& summary) {
  std::map<std::string, double> numbers;
  for (const auto& [key, text] : read_summary(summary)) {
    if (const auto number = parse_real(text)) numbers[key] = *number;
  }
  return numbers;
}

/// Reads what the study can want of a run that ended well; a column that its history does not have becomes a warning.
void read_numbers(const Study& study, const std::filesystem::path& folder, FinishedRun& run) {
  std::vector<HistoryValue> wanted;
  for (const WantedValue& each : study.history_values) wanted.push_back(each.value);
  auto [values, lacking] = read_history_numbers(folder / "history.txt", wanted);
  run.values = numbers_of(folder / "summary.txt");
  run.values.merge(values);
  run.lacking = std::move(lacking);
  for (const auto& [column, hint] : run.lacking) {
    run.record.ending.message += fmt::format("{}warning: its history.txt has no column '{}'. {}",
                                             run.record.ending.message.empty() ? "" : " ", column, hint);
  }
}

/// The command that makes this run alone.
std::string command_of(const std::string& deck, const std::vector<std::string>& overrides) {
  return fmt::format("tether {}{}{}", deck, overrides.empty() ? "" : " --set ", fmt::join(overrides, " --set "));
}

/// The newest checkpoint that an interrupted run of this deck left in the folder; empty where there is none.
std::filesystem::path checkpoint_of(const std::string& deck_effective, const std::filesystem::path& folder) {
  for (const auto& path : checkpoints_in(folder)) {
    try {
      if (read_checkpoint(path).deck_effective == deck_effective) return path;
    } catch (const FileError&) {
      continue;  // damaged: an older one will do, or the start
    }
  }
  return {};
}

/// A run as the command line does it; of a run that ends well the message is its warnings, since its numbers may mean
/// less than they seem to. For the child process: signals end it at its next look.
Ending run_in_folder(const Deck& deck, const std::filesystem::path& folder, const std::string& command, int threads) {
  const Clocks clocks;
  SignalWatch watch;
  std::string warnings;
  const auto warn = [&warnings](const std::string& text) { warnings += "warning: " + text + "\n"; };
  const Ending ending = end_of(deck.file(), [&] {
    Diagnostics diagnostics;
    Loaded loaded = load_scene(deck, {}, diagnostics);
    RunRequest request = request_of(loaded, folder, command);
    request.clocks = clocks;
    request.threads = threads_for(loaded.plan, threads);
    request.restart = checkpoint_of(request.deck_effective, folder);
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

/// A run that went on from a checkpoint has cost more than its last process: its summary knows.
void count_earlier_cost(RunRecord& record, const std::filesystem::path& folder) {
  if (record.ending.exit_code != exit_done) return;
  const auto numbers = numbers_of(folder / "summary.txt");
  record.cpu_seconds = std::max(record.cpu_seconds, numbers.at("cpu_seconds"));
  record.wall_seconds = std::max(record.wall_seconds, numbers.at("wall_seconds"));
}

bool is_interrupted(const Ending& ending) {
  return ending.exit_code == exit_signal + SIGINT || ending.exit_code == exit_signal + SIGTERM;
}

/// Returns whether the ending says something of the run itself. What says nothing of it is tried again by the next
/// sweep: an interruption, a kill, a full disk.
bool is_lasting(const Ending& ending) { return ending.exit_code != exit_file && ending.exit_code < exit_signal; }

}  // namespace

Scheduler::Scheduler(const Study& study, std::filesystem::path out, Shares shares,
                     std::function<void(const SweepProgress&)> progress)
    : study_(study),
      combinations_(combinations(study)),
      out_(std::move(out)),
      jobs_(static_cast<std::size_t>(shares.jobs)),
      threads_(shares.threads),
      progress_(std::move(progress)) {}

Scheduler::Outcome Scheduler::run_all(Sequences& sequences) {
  const auto wanted = sequences.first();
  queue_.assign(wanted.begin(), wanted.end());
  do {
    start_what_fits(sequences);
    if (workers_.count() > 0) heed(watch_.wait(patience));
    take_what_ended(sequences);
    tell_progress();
  } while (!queue_.empty() || workers_.count() > 0);
  heed(watch_.take());
  std::sort(outcome_.runs.begin(), outcome_.runs.end(), [](const FinishedRun& a, const FinishedRun& b) {
    return std::tie(a.variant.combination, a.variant.number) < std::tie(b.variant.combination, b.variant.number);
  });
  return std::move(outcome_);
}

void Scheduler::start_what_fits(Sequences& sequences) {
  while (!queue_.empty() && workers_.count() < jobs_) {
    const Variant variant = queue_.front();
    queue_.pop_front();
    if (!start(variant, sequences)) return queue_.push_front(variant);
  }
}

/// False where it has to wait: the same run, wanted by another combination, is under way.
bool Scheduler::start(const Variant& variant, Sequences& sequences) {
  const Combination& combination = combinations_[variant.combination];
  const Deck deck = read_deck(study_, combination, variant.varied);
  const std::string key = run_key(deck);
  const auto folder = run_folder(out_, key);
  if (runs_already(key)) return false;
  if (auto record = read_record(folder, key)) {
    finish(variant, std::move(*record), true, sequences);
    return true;
  }
  const auto command = command_of(deck.file(), overrides_of(study_, combination, variant.varied));
  workers_.start(next_id_, [&] { return run_in_folder(deck, folder, command, threads_); });
  started_[next_id_++] = {variant, key};
  return true;
}

bool Scheduler::runs_already(const std::string& key) const {
  return std::any_of(started_.begin(), started_.end(), [&](const auto& run) { return run.second.key == key; });
}

void Scheduler::take_what_ended(Sequences& sequences) {
  while (auto ended = workers_.take()) {
    const auto [variant, key] = started_.at(ended->id);
    started_.erase(ended->id);
    seconds_run_ += ended->wall_seconds;
    ended->ending.message = one_line(ended->ending.message);
    if (is_interrupted(ended->ending) && outcome_.signal != 0) continue;  // it was not finished
    RunRecord record{key, ended->ending, ended->cpu_seconds, ended->wall_seconds};
    count_earlier_cost(record, run_folder(out_, key));
    if (is_lasting(record.ending)) write_record(run_folder(out_, key), record);
    finish(variant, std::move(record), false, sequences);
  }
}

void Scheduler::finish(const Variant& variant, RunRecord record, bool reused, Sequences& sequences) {
  FinishedRun run{variant, std::move(record), reused, {}};
  if (!run.failed()) read_numbers(study_, run_folder(out_, run.record.key), run);
  for (const Variant& next : sequences.after(run)) {
    if (outcome_.signal == 0) queue_.push_back(next);
  }
  outcome_.runs.push_back(std::move(run));
}

/// Interrupted: nothing is started any more, and the runs stop at their next look at signals.
void Scheduler::heed(int signal) {
  if (signal != SIGINT && signal != SIGTERM) return;
  outcome_.signal = signal;
  queue_.clear();
  workers_.tell(signal);
}

void Scheduler::tell_progress() const {
  if (!progress_) return;
  const auto& runs = outcome_.runs;
  const auto count = [&](const auto& so) {
    return static_cast<std::size_t>(std::count_if(runs.begin(), runs.end(), so));
  };
  const std::size_t run_now = runs.size() - count([](const FinishedRun& run) { return run.reused; });
  const std::size_t left = queue_.size() + workers_.count();
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start_;
  const double each = run_now > 0 ? seconds_run_ / static_cast<double>(run_now) : 0;
  const double seconds_left = each * static_cast<double>(left) / static_cast<double>(jobs_);
  progress_(
      {runs.size(), count([](const FinishedRun& run) { return run.failed(); }), left, wall.count(), seconds_left});
}

}  // namespace tether
