// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "studies/automatic/resolution.hpp"

namespace tether::automatic {

/// What a run cost.
struct Expense {
  Resolution at;
  double seconds = 0;  ///< of the processor
};

/// What a run costs at the least, to start [s].
constexpr double least_seconds = 1e-3;

/// What runs cost as powers of their resolution, C space^s time^t, by least squares of their logarithms. Costly runs
/// count more: small ones cost what they cost to start.
class CostLaw {
 public:
  /// Takes the powers that are `expected` where resolutions do not differ. Throws std::invalid_argument for no run.
  CostLaw(std::span<const Expense> runs, const Resolution& expected);

  double seconds(const Resolution& at) const;
  /// Returns s and t.
  const Resolution& powers() const { return powers_; }

 private:
  double log_one_ = 0;  ///< of the deck's own resolution
  Resolution powers_;
};

}  // namespace tether::automatic
