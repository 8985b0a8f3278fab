// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "results/checkpoint.hpp"

namespace tether {

/// The checkpoint from which a deck (the text of its deck.effective) is to go on. Throws FileError where it cannot be
/// read, with an offer of the newest whole one beside it, InputError that lists the values in which its deck and this
/// one differ; in.tmax, in.iout but for 38 (which adds a column to the history) and in.tiout may: a run may be made
/// longer.
Checkpoint checkpoint_for(const std::filesystem::path& path, const std::string& deck_effective);

/// What a run from the start finds in its folder.
struct EarlierRun {
  std::string text;  ///< what of it the run replaces or removes; empty where there is nothing
  std::vector<std::filesystem::path> foreign_checkpoints;  ///< whole ones from which no run of this deck goes on
};

EarlierRun earlier_run(const std::filesystem::path& folder, const std::string& deck_effective);

}  // namespace tether
