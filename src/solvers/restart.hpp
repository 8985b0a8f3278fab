// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "results/checkpoint.hpp"

namespace tether {

/// The checkpoint from which a deck (the text of its deck.effective) is to go on. Throws FileError where it cannot be
/// read, with an offer of the newest whole one beside it, InputError that lists the values in which its deck and this
/// one differ; in.tmax, in.iout but for 38 (which adds a column to the history) and in.tiout may: a run may be made
/// longer.
Checkpoint checkpoint_for(const std::filesystem::path& path, const std::string& deck_effective);

}  // namespace tether
