// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "base/process.hpp"
#include "studies/combinations.hpp"
#include "studies/runs/crew.hpp"
#include "studies/runs/run_index.hpp"

namespace tether {

/// How far studies are, for a progress line.
struct SweepProgress {
  std::size_t done = 0, failed = 0, left = 0;
  double wall_seconds = 0, seconds_left = 0;
};

/// Which runs are done.
enum class Doing {
  all,     ///< those that are not finished
  parts,   ///< those of some parts of the studies, for others to collect
  collect  ///< none: what is finished is looked at
};

/// How a study is to be run.
struct StudyOptions {
  std::filesystem::path out;  ///< folder for the tables and, below it, the runs
  Crew& crew;                 ///< who does the runs
  int threads = 1;            ///< of each run
  std::string command;        ///< as it was typed, for the files' provenance
  std::function<void(const SweepProgress&)> progress;
  Doing doing = Doing::all;
  std::set<std::size_t> parts = {};  ///< their numbers, from 1
};

/// A study whose runs are wanted; a single run is a study, too.
struct StudyRun {
  Study study;
  std::filesystem::path out;                                          ///< the study's folder
  double most_cpu_seconds = std::numeric_limits<double>::infinity();  ///< a run that takes more is stopped
};

/// The runs of a study that have come to an end, in the order of their combinations, and what they led to.
struct StudyOutcome {
  std::vector<FinishedRun> runs;
  Sequences sequences;
  bool is_whole = true;        ///< false where a signal came before its end, or some are not done
  std::size_t unfinished = 0;  ///< parts of it that were to be done or collected and are not finished
};

/// Studies fall into parts, each of which can be done without knowing how others end: a run, or the runs of a
/// bisection, or all runs of a deck's map that are wanted one after the other. Parts are numbered from 1, study by
/// study.
class PartNumbers {
 public:
  /// The number of the part of each of the runs that the next study wants first.
  std::vector<std::size_t> of(const Study& study, const std::vector<Variant>& first);
  /// Parts of all studies so far.
  std::size_t count() const { return count_; }

 private:
  std::size_t count_ = 0;
};

/// Deals out what studies want to a crew: several runs side by side, each in a folder and a process of its own, the
/// longest first as far as plans know. A run that had been finished before is not run again.
class Scheduler {
 public:
  /// The references must outlive this.
  Scheduler(const std::vector<StudyRun>& studies, const StudyOptions& options);
  /// Ends the runs that are under way.
  ~Scheduler() { options_.crew.drop_all(); }
  Scheduler(const Scheduler&) = delete;
  Scheduler& operator=(const Scheduler&) = delete;

  /// All runs, or those that were finished when a signal came: SIGINT or SIGTERM, which then is `signal`.
  struct Outcome {
    std::vector<StudyOutcome> studies;
    int signal = 0;
    std::set<std::size_t> unfinished;  ///< parts of those that were to be done or collected
  };
  /// Throws FileError.
  Outcome run_all();

 private:
  /// A run that is wanted: of which study, and which one.
  struct Wanted {
    std::size_t study = 0;
    std::size_t part = 0;
    Variant variant;
    std::string key = {};  // of run_key(); empty until it is looked up
  };
  /// The order of the queue: the longest first, then those of which nobody knows how long they take, as they came.
  struct Rank {
    double seconds = -1;  // expected; -1: not known
    std::size_t number = 0;
    bool operator<(const Rank& other) const {
      return std::tuple(-seconds, number) < std::tuple(-other.seconds, other.number);
    }
  };

  void want_first();
  void do_what_is_wanted();
  void collect();
  bool is_wanted(std::size_t part) const;
  void start_what_fits();
  bool start(Wanted& wanted);
  Deck deck_of(const Wanted& wanted) const;
  RunTask task_of(const Wanted& wanted) const;
  void take_what_ended();
  void take_finished_before();
  void look_up(Wanted& wanted) const;
  std::optional<FinishedRun> finished_before(const Wanted& wanted) const;
  std::filesystem::path folder_of(const Wanted& wanted) const;
  void finish(const Wanted& wanted, FinishedRun run);
  void estimate_one();
  void take_estimate();
  void heed(int signal);
  double seconds_passed() const;
  void tell_progress() const;

  const std::vector<StudyRun>& studies_;
  const StudyOptions& options_;
  std::vector<std::vector<Combination>> combinations_;  // of each study
  std::vector<RunIndex> indices_;                       // of each study
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  SignalWatch watch_{SIGINT, SIGTERM, SIGCHLD};
  std::map<Rank, Wanted> queue_;
  std::size_t next_number_ = 0;
  std::map<std::size_t, Wanted> started_;      // by the identifiers that the crew has
  std::set<std::filesystem::path> under_way_;  // their folders
  std::size_t next_id_ = 0;
  Workers estimators_;                              // one at a time
  double seconds_estimating_ = 0;                   // of the processor
  std::size_t done_ = 0, failed_ = 0, reused_ = 0;  // runs
  double seconds_run_ = 0;                          // wall seconds of the runs that were run
  Outcome outcome_;
};

}  // namespace tether
