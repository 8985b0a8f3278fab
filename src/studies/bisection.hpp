// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace tether {

/// Where a bisection looks, and how close it goes: until the interval is as short as tolerance times the larger of
/// low and high in size.
struct Interval {
  double low = 0, high = 0, tolerance = 0;
};

constexpr const char* exit_code_key = "exit_code";

/// What of a run is looked at, and the bounds between which it holds.
struct Criterion {
  std::string key;  ///< exit_code_key, or a key of summary.txt
  double at_least = -std::numeric_limits<double>::infinity();
  double at_most = std::numeric_limits<double>::infinity();

  /// Not for what is not a number.
  bool holds(double value) const { return value >= at_least && value <= at_most; }
};

/// The largest value for which something holds, by halving an interval at whose lower end it holds and at whose upper
/// end it does not.
class Bisection {
 public:
  explicit Bisection(const Interval& interval) : interval_(interval) {}

  /// The values to look at next: at first both ends, then, when both were looked at, a middle; nothing at the end.
  std::vector<double> next() const;
  /// What was seen at one of them.
  void take(double value, bool holds);

  /// "found"; "both ends hold", "both ends fail" or "fails at the lower end alone": then nothing was found; "not yet".
  std::string verdict() const;
  bool found() const { return verdict() == "found"; }
  /// Largest value at which it held, smallest at which it did not; not numbers where there was none.
  double holds() const { return holds_; }
  double fails() const { return fails_; }

 private:
  bool ends_differ() const { return low_holds_ == true && high_holds_ == false; }

  Interval interval_;
  std::optional<bool> low_holds_, high_holds_;
  double holds_ = std::numeric_limits<double>::quiet_NaN(), fails_ = holds_;
};

}  // namespace tether
