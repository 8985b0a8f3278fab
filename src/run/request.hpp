// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "plan/load.hpp"
#include "results/results.hpp"
#include "run/clocks.hpp"
#include "solvers/solver.hpp"

namespace tether {

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
  Clocks clocks;                                   ///< from when on the run's time counts
  std::function<void(const std::string&)> remark;  ///< called with what the run replaces in its folder
};

/// The request of a deck as it was loaded, into a folder; `command` is for the files' provenance.
RunRequest request_of(const Loaded& loaded, const std::filesystem::path& folder, const std::string& command);

}  // namespace tether
