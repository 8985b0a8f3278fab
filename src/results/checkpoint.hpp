// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "results/results.hpp"

namespace tether {

/// When an output is due: its interval, and the next time [time].
struct SavedDue {
  double interval = 0, next = 0;
};

/// A run between two of its steps: with this and its deck it goes on as if it had never stopped.
struct Checkpoint {
  Provenance provenance;
  std::string deck_effective;         ///< the run's deck with all values and particle data
  double time = 0;                    ///< [time]
  SavedState state;                   ///< the solver's
  std::vector<Record> records;        ///< the history so far: one at least
  std::vector<SavedDue> dues;         ///< of history, points, grid, checkpoint
  std::size_t point_snapshots = 0;    ///< written so far
  std::size_t grid_snapshots = 0;     ///< written so far
  std::vector<double> watched;        ///< what the watch for runs gone wrong remembers
  std::vector<std::string> messages;  ///< of the run so far, those of its deck left out
  Seconds whole, setup;               ///< what the run took so far, and what of it before its first steps
  std::vector<CostPart> parts;        ///< of its steps
  std::string written_by;             ///< program, version and git hash, of one that was read
};

/// Returns what stands in written_by of this program's checkpoints.
std::string this_program();

/// Writes the file under a temporary name, hands it to the disk and renames it, so that under its own name there is a
/// whole checkpoint or none. The attribute `checksum` is the SHA-256 of the file with 64 zeros in that place. Times
/// taken and the command stand in attributes: the variables are the same in every run of a deck. Throws FileError.
void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint);

/// Throws FileError where the file cannot be read or its checksum does not fit.
Checkpoint read_checkpoint(const std::filesystem::path& path);

/// The files checkpoint-N.nc of a folder, the newest (largest N) first.
std::vector<std::filesystem::path> checkpoints_in(const std::filesystem::path& folder);

/// The newest checkpoint that a run of this deck left in the folder when it was interrupted; empty where there is none
/// that is whole.
std::filesystem::path newest_checkpoint(const std::filesystem::path& folder, const std::string& deck_effective);

/// Throws FileError where it stays.
void remove_checkpoint(const std::filesystem::path& path);

/// Writes checkpoint-N.nc with the next N, then removes all but the two newest. Returns its path. Throws FileError.
std::filesystem::path add_checkpoint(const std::filesystem::path& folder, const Checkpoint& checkpoint);

}  // namespace tether
