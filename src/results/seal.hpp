// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

#include "results/netcdf_file.hpp"
#include "results/results.hpp"

namespace tether {

/// Makes room for the seal: the first attribute of a 64-bit-offset file, before any other.
void define_seal(NetcdfFile& file);

/// Puts the SHA-256 of the closed file (with the seal's 64 digits 0) into its seal. Throws FileError.
void seal(const std::filesystem::path& path);

/// "" where the file is as it was sealed; else what is wrong with it. No NetCDF call looks at the file before: a
/// damaged header may take the library anywhere. Throws FileError where it cannot be read at all.
std::string broken_seal(const std::filesystem::path& path);

/// Which snapshots are wanted of an earlier file: the first `count` of the run with this SHA-256 of its deck.effective,
/// with the fields of `like`, as many numbers each.
struct WantedSnapshots {
  const Snapshot& like;
  std::size_t count = 0;
  std::string run_sha256;
  bool changing = false;  ///< the number of points; `like` has that of the last
};

/// Hands the snapshots of a file (particles.nc or mesh.nc) to `append`, one by one. Returns "", or where some cannot be
/// read or are of another run, how many and why. What `append` throws goes through.
std::string replay_snapshots(const std::filesystem::path& file, const WantedSnapshots& wanted,
                             const std::function<void(const Snapshot&)>& append);

}  // namespace tether
