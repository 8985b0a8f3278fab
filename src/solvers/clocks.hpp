// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/resource.h>

#include <chrono>

namespace tether {

/// What a run has taken of the machine, those parts of it included that ran before a restart [seconds].
class Clocks {
 public:
  double wall_seconds() const {
    return wall_before_ + std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_).count();
  }
  double cpu_seconds() const { return cpu_before_ + cpu_now() - cpu_; }
  void add(double cpu, double wall) { cpu_before_ += cpu, wall_before_ += wall; }

  static double peak_memory_mb() { return 1e-3 * static_cast<double>(used().ru_maxrss); }  // Linux counts kilobytes

 private:
  static rusage used() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage;
  }
  static double seconds(const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  }
  static double cpu_now() {
    const rusage usage = used();
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
  }
  std::chrono::steady_clock::time_point wall_ = std::chrono::steady_clock::now();
  double cpu_ = cpu_now();
  double cpu_before_ = 0, wall_before_ = 0;
};

/// How far a solver may go before it comes back, so that it comes back several times a second, whatever a step costs:
/// for the progress line, and to hear of signals. What it computes does not depend on it.
class Pace {
 public:
  /// Time to go ahead by, when steps are of length dt [time].
  double ahead(double dt) const { return steps_ * dt; }
  /// Told each time the solver came back, at this wall time [seconds].
  void came_back(double wall) {
    const double taken = wall - last_;
    last_ = wall;
    if (taken < shortest) steps_ *= 2;
    if (taken > longest && steps_ > 1) steps_ /= 2;
  }

 private:
  static constexpr double shortest = 0.05, longest = 0.5;  // [seconds]
  double steps_ = 1;
  double last_ = 0;
};

}  // namespace tether
