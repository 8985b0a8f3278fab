// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "studies/finished_run.hpp"

namespace tether {

/// Which runs a study wants, by its mode: a run of each combination (grid), several of each (ensemble), or one after
/// the other of each (bisect). Knows nothing of how they are run.
class Sequences {
 public:
  explicit Sequences(const Study& study);

  /// Those that can be run at once.
  std::vector<Variant> first();
  /// Those that are wanted now that this run has ended.
  std::vector<Variant> after(const FinishedRun& run);

  /// One a combination, in mode bisect.
  const std::vector<Bisection>& bisections() const { return bisections_; }

 private:
  void add(std::vector<Variant>& wanted, std::size_t combination, std::optional<double> varied);
  std::vector<Variant> next(std::size_t combination);

  const Study& study_;
  std::vector<std::size_t> numbers_;  // runs wanted so far, a combination
  std::vector<Bisection> bisections_;
};

}  // namespace tether
