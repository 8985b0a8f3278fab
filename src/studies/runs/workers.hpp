// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>
#include <chrono>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>

#include "base/process.hpp"

namespace tether {

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
  ~Workers() { drop_all(); }
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
  /// Kills all, and forgets them.
  void drop_all();

 private:
  struct Process {
    pid_t pid = 0;
    int message = -1;  // end of the pipe from which its message is read
    std::chrono::steady_clock::time_point start;
  };
  std::map<std::size_t, Process> running_;
};

}  // namespace tether
