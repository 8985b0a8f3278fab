// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "results/checkpoint.hpp"

namespace tether {

/// Times k * interval at which something is due; never for an interval of 0.
class Due {
 public:
  explicit Due(double interval) : interval_(interval) { follow(0); }
  double next() const { return next_; }
  /// Whether it is due at this time; if so, the next is after it.
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

}  // namespace tether
