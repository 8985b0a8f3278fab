// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <csignal>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>

#include "base/failure.hpp"

namespace tether {

// Exit codes of the contract; a signal's is 128 + its number.
/// Stands where a run that is asked for has not ended.
constexpr int exit_none = -1;
constexpr int exit_done = 0, exit_input = 2, exit_run = 3, exit_file = 4, exit_verdict = 5, exit_signal = 128;

/// How a piece of work ended: the contract's exit code, and what there is to say of it ("" where all went well).
struct Ending {
  int exit_code = exit_done;
  std::string message;
  std::optional<Failure> failure = {};  ///< of a run that went wrong (exit_run)
};

/// Does the work; what it throws becomes the exit code and the message, which begins with `name` unless it names its
/// file itself, and ends with a line end.
Ending end_of(const std::string& name, const std::function<void()>& work);

/// Holds signals back while it lives, so that the program asks for them where it can heed them, instead of being
/// stopped anywhere. A child made by fork() inherits it. Only for a program of one thread.
class SignalWatch {
 public:
  explicit SignalWatch(std::initializer_list<int> signals = {SIGINT, SIGTERM});
  /// Ends the watch. What came meanwhile and was not asked for takes its usual course.
  ~SignalWatch();
  SignalWatch(const SignalWatch&) = delete;
  SignalWatch& operator=(const SignalWatch&) = delete;

  /// Takes one of the signals that have come, and returns its number; 0 where there is none.
  int take() { return wait(0); }
  /// Does the same, but waits so many seconds for one, or until there is something to read in an open file, if one is
  /// given.
  int wait(double seconds, int file = -1);

 private:
  sigset_t watched_, before_;
};

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

/// Both clocks of this process, from some moment on, with what its children took that have ended.
Seconds seconds_now();

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

/// Lets the process keep the memory that it frees. Steps make and drop arrays of one size again and again; by glibc's
/// own rules large ones go back to the kernel each time, which then clears their pages anew: in space that was up to a
/// third of a step. To be called before anything large is made.
void keep_freed_memory();

/// Most memory that the process has held at a time [MB]. The kernel's other count of it, ru_maxrss, begins with what
/// the parent held, and stands in where there is no /proc.
double peak_memory_mb();

std::string host_name();        ///< of this machine
std::string program_version();  ///< "0.1.0"
std::string git_hash();         ///< of the tree this program was built from, "-dirty" after it if it had changes

}  // namespace tether
