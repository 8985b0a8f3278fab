// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <ctime>

namespace tether {

/// What something took: of the processor, on all of the process's threads, and by the clock on the wall [seconds]. On a
/// machine with other work the second is the larger one.
struct Seconds {
  double cpu = 0, wall = 0;

  Seconds& operator+=(const Seconds& more) {
    cpu += more.cpu, wall += more.wall;
    return *this;
  }
  friend Seconds operator+(Seconds a, const Seconds& b) { return a += b; }
  friend Seconds operator-(const Seconds& a, const Seconds& b) { return {a.cpu - b.cpu, a.wall - b.wall}; }
};

/// Both clocks of this process, from some moment on.
inline Seconds seconds_now() {
  timespec cpu{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &cpu);
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now().time_since_epoch();
  return {static_cast<double>(cpu.tv_sec) + 1e-9 * static_cast<double>(cpu.tv_nsec), wall.count()};
}

/// Adds what its life took to a sum.
class Stopwatch {
 public:
  explicit Stopwatch(Seconds& sum) : sum_(sum) {}
  ~Stopwatch() { sum_ += seconds_now() - start_; }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  Seconds& sum_;
  Seconds start_ = seconds_now();
};

}  // namespace tether
