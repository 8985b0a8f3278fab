// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/resource.h>

#include <algorithm>
#include <vector>

#include "base/seconds.hpp"
#include "results/checkpoint.hpp"

namespace tether {

/// What a run has taken of the machine, those parts of it included that ran before a restart. The set-up is all that
/// comes before the first step of each process: the reading of the deck, the scene, the first outputs; or what was
/// saved.
class Clocks {
 public:
  void go_on_from(const Checkpoint& saved) { before_ = saved.whole, setup_ = saved.setup, parts_before_ = saved.parts; }
  void end_of_setup() { setup_ += seconds_now() - start_; }

  Seconds whole() const { return before_ + (seconds_now() - start_); }
  Seconds setup() const { return setup_; }
  /// The parts of steps that a solver measured in this process, and what they took before.
  std::vector<CostPart> with_earlier(std::vector<CostPart> parts) const {
    for (CostPart& part : parts) {
      const auto named = [&part](const CostPart& earlier) { return earlier.name == part.name; };
      const auto earlier = std::find_if(parts_before_.begin(), parts_before_.end(), named);
      if (earlier != parts_before_.end()) part.taken += earlier->taken;
    }
    return parts;
  }

  static double peak_memory_mb() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return 1e-3 * static_cast<double>(usage.ru_maxrss);  // Linux counts kilobytes
  }

 private:
  Seconds start_ = seconds_now();
  Seconds before_, setup_;
  std::vector<CostPart> parts_before_;
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
