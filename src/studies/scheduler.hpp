// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>
#include <chrono>
#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/process.hpp"
#include "studies/combinations.hpp"

namespace tether {

/// Seconds between looks at the clock while nothing ends.
constexpr double patience = 1;

/// How a piece of work ended that had a process of its own, and what it cost.
struct Finished {
  std::size_t id = 0;
  Ending ending;
  double cpu_seconds = 0, wall_seconds = 0;
};

/// Work in processes of their own, several side by side: what crashes, loses only itself. Made by fork() without exec:
/// starting a program costs as much as a short run. The program must have one thread. When it dies, its workers do.
class Workers {
 public:
  Workers() = default;
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  std::size_t count() const { return running_.size(); }
  bool has(std::size_t id) const { return running_.count(id) > 0; }
  /// Does the work in a new process; `id` comes back with its end. Throws FileError where there can be no process.
  void start(std::size_t id, const std::function<Ending()>& work);
  /// One that has ended, if any. A process that a signal ended has the exit code 128 + signal.
  std::optional<Finished> take();
  /// Sends a signal to all.
  void tell(int signal) const;

 private:
  struct Process {
    pid_t pid = 0;
    int message = -1;  // end of the pipe from which its message is read
    std::chrono::steady_clock::time_point start;
  };
  std::map<std::size_t, Process> running_;
};

/// How far a sweep is, for a progress line.
struct SweepProgress {
  std::size_t done = 0, failed = 0, left = 0;
  double wall_seconds = 0, seconds_left = 0;
};

/// How the cores are shared out among runs.
struct Shares {
  int jobs = 1;     ///< runs side by side
  int threads = 1;  ///< of each run
};

/// How a study is to be run.
struct StudyOptions {
  std::filesystem::path out;  ///< folder for the tables and, below it, the runs
  Shares shares;
  std::string command;  ///< as it was typed, for the files' provenance
  std::function<void(const SweepProgress&)> progress;
};

/// Runs what a study wants, several runs side by side, each in a folder and a process of its own. A run that had been
/// finished before is not run again.
class Scheduler {
 public:
  /// The references must outlive this.
  Scheduler(const Study& study, std::filesystem::path out, Shares shares,
            std::function<void(const SweepProgress&)> progress);

  /// All runs, or those that were finished when a signal came: SIGINT or SIGTERM, which then is `signal`.
  struct Outcome {
    std::vector<FinishedRun> runs;  ///< in the order of their combinations
    int signal = 0;
  };
  /// Throws FileError; the runs under way are then ended.
  Outcome run_all(Sequences& sequences);

 private:
  struct Started {
    Variant variant;
    std::string key;
  };
  void start_what_fits(Sequences& sequences);
  bool start(const Variant& variant, Sequences& sequences);
  bool runs_already(const std::string& key) const;
  void take_what_ended(Sequences& sequences);
  void finish(const Variant& variant, RunRecord record, bool reused, Sequences& sequences);
  void heed(int signal);
  void tell_progress() const;

  const Study& study_;
  std::vector<Combination> combinations_;
  std::filesystem::path out_;
  std::size_t jobs_;
  int threads_;
  std::function<void(const SweepProgress&)> progress_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  SignalWatch watch_{SIGINT, SIGTERM, SIGCHLD};
  Workers workers_;
  std::deque<Variant> queue_;
  std::map<std::size_t, Started> started_;  // by the identifiers of the workers
  std::size_t next_id_ = 0;
  double seconds_run_ = 0;  // wall seconds of the runs that were run
  Outcome outcome_;
};

}  // namespace tether
