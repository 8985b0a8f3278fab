// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>
#include <map>
#include <string>

#include "studies/bisection.hpp"
#include "studies/combinations.hpp"
#include "studies/run_record.hpp"

namespace tether {

/// A run of a study that has come to an end, well or not.
struct FinishedRun {
  Variant variant;
  RunRecord record;
  bool reused = false;                   ///< it had been run before
  std::map<std::string, double> values;  ///< of its summary.txt, and the study's of history.txt; none where it failed
  std::map<std::string, std::string> lacking = {};  ///< columns that its history.txt has not; what may have been meant

  bool failed() const { return record.ending.exit_code != exit_done; }
  /// Whether it came to its end or diverged. A full disk, a kill or a scene that cannot be built tell nothing of a
  /// criterion.
  bool decides() const { return !failed() || record.ending.exit_code == exit_run; }
  /// One of them, or exit_code; not a number where the run has none of that name.
  double value(const std::string& key) const {
    if (key == exit_code_key) return record.ending.exit_code;
    const auto found = values.find(key);
    return found == values.end() ? std::numeric_limits<double>::quiet_NaN() : found->second;
  }
};

}  // namespace tether
