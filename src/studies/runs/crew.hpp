// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "studies/runs/run_task.hpp"

namespace tether {

/// Seconds between looks at the clock while nothing ends.
constexpr double patience = 1;

/// A run that a crew is done with.
struct Done {
  std::size_t id = 0;
  RunRecord record;
  bool given_back = false;  ///< whoever did it is lost: the record says nothing, the run is to be done by another
};

/// Those who do the runs of studies, each run in a process of its own: on this machine, or on many. Whoever does a run
/// also leaves its record in its folder.
class Crew {
 public:
  Crew() = default;
  virtual ~Crew() = default;
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  /// Most runs under way at a time.
  virtual std::size_t size() const = 0;
  /// Runs under way.
  virtual std::size_t count() const = 0;
  /// Has one begin; `id` comes back with its end. Only where count() is less than size(). Throws FileError where it
  /// cannot begin.
  virtual void start(std::size_t id, const RunTask& task) = 0;
  /// One that has ended, if any. Throws FileError where its record cannot be written, or nobody is left to do runs.
  virtual std::optional<Done> take() = 0;
  /// Sends a signal to all runs under way.
  virtual void tell(int signal) = 0;
  /// Ends all runs under way at once, and forgets them.
  virtual void drop_all() = 0;
  /// A file that can be read when something has ended; -1 where SIGCHLD says so.
  virtual int news() const = 0;
};

}  // namespace tether
