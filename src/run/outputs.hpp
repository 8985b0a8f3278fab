// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "fields/fields_in_turn.hpp"
#include "grid/mesh.hpp"
#include "loops/task_queue.hpp"
#include "physics/solver.hpp"
#include "plan/plan.hpp"
#include "results/checkpoint.hpp"
#include "results/result_folder.hpp"
#include "results/seal.hpp"
#include "run/request.hpp"

namespace tether {

/// Times k * interval at which something is due; never for an interval of 0.
class Due {
 public:
  explicit Due(double interval) : interval_(interval) { follow(0); }
  double next() const { return next_; }
  /// Returns whether it is due at this time; if so, the next is after it.
  bool passed(double time) {
    if (!(time >= next_)) return false;
    follow(time);
    return true;
  }
  SavedDue save() const { return {interval_, next_}; }
  /// Goes on as saved at this time; from this time on where the deck has another interval now.
  void restore(const SavedDue& saved, double time) {
    follow(time);
    if (saved.interval == interval_) next_ = saved.next;
  }

 private:
  /// Part of an interval by which something may come early, so that rounding does not put it off by a step.
  static constexpr double early = 1e-9;

  void follow(double time) {
    const double never = std::numeric_limits<double>::max();
    const double k = std::floor(time / interval_ + early) + 1;
    next_ = interval_ > 0 ? std::max((k - early) * interval_, std::nextafter(time, never)) : never;
  }
  double interval_;
  double next_ = 0;
};

/// What a run has written so far, and what it is to write when. Plan, request and solver must outlive it.
class RunOutputs {
 public:
  /// Makes the run's folder anew. Throws FileError, as all of it does.
  RunOutputs(const Plan& plan, const RunRequest& request, const Solver& solver);

  void write_the_start();
  /// From now on by a thread of its own: what it cannot write, a later call throws.
  void write_meanwhile() { queue_.start_thread(); }
  /// Until all of it is with the system.
  void wait() { queue_.wait(); }
  double next() const;               ///< time at which something is due next, a checkpoint too [time]
  void write_what_is_due(bool end);  ///< all but the checkpoint; at the end everything that is on
  bool takes_checkpoint(bool end);   ///< whether one is due now

  /// Into messages.txt alone.
  void note(const std::string& text) { folder_.message(text); }
  /// Into messages.txt, into the checkpoints so that it stands there after a restart, too, and to the request's warn.
  void warn(const std::string& text);

  /// The outputs' part of a checkpoint.
  void save(Checkpoint& checkpoint) const;
  /// Writes the checkpoint's part of all files once more, and continues after it.
  void restore(const Checkpoint& checkpoint);

  const History& history() const { return history_; }
  ResultFolder& folder() { return folder_; }

 private:
  void keep(const std::string& line);
  void write(Record record);
  void write_points();
  void write_points(const FieldsInTurn& snapshot);
  void write_grid();
  void write_grid(Snapshot snapshot);
  void take_over(const std::string& name, const WantedSnapshots& wanted,
                 const std::function<void(const Snapshot&)>& write_one);

  const Plan& plan_;
  const RunRequest& request_;
  const Solver& solver_;
  ResultFolder folder_;
  History history_;
  std::size_t point_snapshots_ = 0, grid_snapshots_ = 0;
  std::vector<std::string> messages_;  // of the run, beside those of its deck
  Due history_due_, points_due_, grid_due_, checkpoint_due_;
  TaskQueue queue_;  // of what NetCDF writes, which is not made for two threads at once
};

}  // namespace tether
