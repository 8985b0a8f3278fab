// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

#include "results/results.hpp"

namespace tether {

/// Hands the first `count` snapshots of a file (particles.nc or mesh.nc) to `append`, one by one; their fields are
/// those of `like`. Returns "", or where some cannot be read, how many and why: the run goes on without them.
std::string replay_snapshots(const std::filesystem::path& file, const Snapshot& like, std::size_t count,
                             const std::function<void(const Snapshot&)>& append);

}  // namespace tether
