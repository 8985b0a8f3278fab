// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/run_pool.hpp"

#include <sys/resource.h>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>

#include "base/diagnostics.hpp"
#include "base/text.hpp"
#include "studies/combinations.hpp"
#include "studies/run_record.hpp"
#include "studies/sweep.hpp"

namespace tether {
namespace {

namespace fs = std::filesystem;

/// Returns where a run of one deck has written, by its key; a bisection is read from its own folder.
fs::path files_of(const StudyRun& run) {
  if (run.study.mode == Mode::bisect) return run.out;
  return run_folder(run.out, run_key(read_deck(run.study, combinations(run.study).front())));
}

std::optional<RunRecord> record_of(const StudyRun& run) {
  return read_record(files_of(run), run_key(read_deck(run.study, combinations(run.study).front())));
}

/// Runs in the process of a run. A kill or a full disk leaves no record of a run: the last line of the report names it.
Ending sweep_alone(const StudyRun& run, const std::string& command, int threads) {
  return end_of(run.study.file, [&] {
    const SweepResult result = sweep(run.study, {run.out, {1, threads}, command, {}});
    if (result.signal != 0) throw Interrupted(result.signal, "interrupted");
    if (!result.verdicts.empty()) throw RunError(result.verdicts.front());
    if (run.study.mode == Mode::bisect || record_of(run)) return;
    const std::string why = split_lines(result.report).back();
    if (result.file_trouble > 0) throw FileError(why);
    throw RunError(why);
  });
}

/// Limits what this process, and each one that it starts, may take of the processor: the kernel ends one that takes
/// more. Whole seconds, rounded up.
void limit_cpu(double seconds) {
  if (!std::isfinite(seconds)) return;
  const auto whole = static_cast<rlim_t>(std::max(1., std::ceil(seconds)));
  const rlimit limit{whole, whole + 1};
  setrlimit(RLIMIT_CPU, &limit);
}

/// How a run ended, by the record that it left; else by how its process did.
RunEnd end_of_run(const StudyRun& run, const Finished& process) {
  RunEnd end{process.ending, files_of(run), process.cpu_seconds};
  const bool has_record = process.ending.exit_code == exit_done && run.study.mode != Mode::bisect;
  if (const auto record = has_record ? record_of(run) : std::nullopt)
    end.ending = record->ending, end.cpu_seconds = record->cpu_seconds;
  end.ending = {end.ending.exit_code, one_line(end.ending.message)};
  return end;
}

/// Runs under way and those that wait.
class Pool {
 public:
  Pool(const std::vector<StudyRun>& runs, Shares shares, const std::string& command,
       const std::function<void(const SweepProgress&)>& progress)
      : runs_(runs),
        jobs_(static_cast<std::size_t>(shares.jobs)),
        threads_(shares.threads),
        command_(command),
        progress_(progress),
        ends_(runs.size()) {}

  std::vector<RunEnd> run_all() {
    while (next_ < runs_.size() || workers_.count() > 0) {
      while (next_ < runs_.size() && workers_.count() < jobs_) start();
      heed(watch_.wait(patience));
      while (auto ended = workers_.take()) take(*ended);
      tell();
    }
    heed(watch_.take());
    if (signal_ != 0) throw Interrupted(signal_, "interrupted; the same command goes on where this one was");
    return std::move(ends_);
  }

 private:
  void start() {
    const StudyRun& run = runs_[next_];
    workers_.start(next_++, [&] {
      limit_cpu(run.most_cpu_seconds);
      return sweep_alone(run, command_, threads_);
    });
  }
  void take(const Finished& ended) {
    ends_[ended.id] = end_of_run(runs_.at(ended.id), ended);
    ++done_, failed_ += ends_[ended.id].ending.exit_code == exit_done ? 0U : 1U;
    seconds_run_ += ended.wall_seconds;
  }
  /// Interrupted: nothing is started any more, and the runs stop at their next look at signals.
  void heed(int signal) {
    if (signal != SIGINT && signal != SIGTERM) return;
    signal_ = signal;
    next_ = runs_.size();
    workers_.tell(signal);
  }
  void tell() const {
    if (!progress_) return;
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start_;
    const std::size_t left = runs_.size() - done_;
    const double each = done_ > 0 ? seconds_run_ / static_cast<double>(done_) : 0;
    progress_({done_, failed_, left, wall.count(), each * static_cast<double>(left) / static_cast<double>(jobs_)});
  }

  const std::vector<StudyRun>& runs_;
  std::size_t jobs_;
  int threads_;
  const std::string& command_;
  const std::function<void(const SweepProgress&)>& progress_;
  std::vector<RunEnd> ends_;
  SignalWatch watch_{SIGINT, SIGTERM, SIGCHLD};
  Workers workers_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::size_t next_ = 0, done_ = 0, failed_ = 0;
  double seconds_run_ = 0;
  int signal_ = 0;
};

}  // namespace

std::vector<RunEnd> run_all(const std::vector<StudyRun>& runs, Shares shares, const std::string& command,
                            const std::function<void(const SweepProgress&)>& progress) {
  return Pool(runs, shares, command, progress).run_all();
}

}  // namespace tether
