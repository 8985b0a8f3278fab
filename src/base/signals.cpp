// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/signals.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>

namespace tether {

SignalWatch::SignalWatch(std::initializer_list<int> signals) : watched_{}, before_{} {
  sigemptyset(&watched_);
  for (const int signal : signals) sigaddset(&watched_, signal);
  sigprocmask(SIG_BLOCK, &watched_, &before_);
}

SignalWatch::~SignalWatch() { sigprocmask(SIG_SETMASK, &before_, nullptr); }

int SignalWatch::wait(double seconds) {
  const double whole = std::floor(seconds);
  const timespec patience{static_cast<time_t>(whole), static_cast<long>(1e9 * (seconds - whole))};
  return std::max(sigtimedwait(&watched_, nullptr, &patience), 0);
}

}  // namespace tether
