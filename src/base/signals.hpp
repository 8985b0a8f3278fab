// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <csignal>
#include <initializer_list>

namespace tether {

/// Holds signals back while it lives, so that the program asks for them where it can heed them, instead of being
/// stopped anywhere. A child made by fork() inherits it. Only for a program of one thread.
class SignalWatch {
 public:
  explicit SignalWatch(std::initializer_list<int> signals = {SIGINT, SIGTERM});
  /// What came meanwhile and was not asked for takes its usual course.
  ~SignalWatch();
  SignalWatch(const SignalWatch&) = delete;
  SignalWatch& operator=(const SignalWatch&) = delete;

  /// Takes one of the signals that have come, and returns its number; 0 where there is none.
  int take() { return wait(0); }
  /// The same, but waits so many seconds for one.
  int wait(double seconds);

 private:
  sigset_t watched_, before_;
};

}  // namespace tether
