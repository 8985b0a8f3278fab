// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "base/signals.hpp"
#include "studies/finished_run.hpp"
#include "studies/sequences.hpp"
#include "studies/workers.hpp"

namespace tether {

/// How far a sweep is, for a progress line.
struct SweepProgress {
  std::size_t done = 0, failed = 0, left = 0;
  double wall_seconds = 0, seconds_left = 0;
};

/// Runs what a study wants, several runs side by side, each in a folder and a process of its own. A run that had been
/// finished before is not run again.
class Scheduler {
 public:
  /// The references must outlive this.
  Scheduler(const Study& study, std::filesystem::path out, int jobs,
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
