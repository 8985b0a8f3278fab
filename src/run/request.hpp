// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/process.hpp"
#include "physics/solver.hpp"
#include "plan/load.hpp"
#include "results/checkpoint.hpp"
#include "results/results.hpp"

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
  /// Called each time the solver came back, at this wall time [seconds].
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

/// How far a run is, for a progress line.
struct Progress {
  double time = 0, tmax = 0, dt = 0;
  RunCounts counts;
  double wall_seconds = 0;
};

/// Everything a run needs next to its plan.
struct RunRequest {
  std::filesystem::path folder;
  Provenance provenance;
  std::string deck_effective;                      ///< text of deck.effective
  std::vector<std::string> messages;               ///< on the deck, for messages.txt
  std::function<void(const Progress&)> progress;   ///< called at every record and now and then between
  std::function<void(const std::string&)> warn;    ///< called with every warning of the run
  std::function<int()> interrupted;                ///< asked several times a second: the signal to stop for, or 0
  std::filesystem::path restart;                   ///< checkpoint to go on from; empty: from the start
  std::shared_ptr<const std::string> mesh_text;    ///< of the file next to deck.effective; null without one
  std::string deck;                                ///< its file, for others that want the folder
  int threads = 1;                                 ///< that share the work
  Clocks clocks;                                   ///< from when on the run's time counts
  std::function<void(const std::string&)> remark;  ///< called with what the run replaces in its folder
};

/// The request of a deck as it was loaded, into a folder; `command` is for the files' provenance.
RunRequest request_of(const Loaded& loaded, const std::filesystem::path& folder, const std::string& command);

}  // namespace tether
