// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include "fields/fields_in_turn.hpp"
#include "results/results.hpp"
#include "results/snapshot_file.hpp"
#include "results/vtk_series.hpp"

namespace tether {

/// Writes particles.nc, fields over (time, point), and where they are wanted VTK files beside it. Nothing is created
/// before the first snapshot; each one is with the system before append() returns.
/// While the run goes on its NetCDF-4 files are locked by HDF5; who wants to read them then sets
/// HDF5_USE_FILE_LOCKING=FALSE.
class PointWriter {
 public:
  /// `changing`: how many points there are.
  PointWriter(std::filesystem::path folder, Provenance provenance, VtkFiles vtk = VtkFiles::automatic,
              bool changing = false);
  /// The snapshot has the fields `x` and `y`, and the same fields every time, and, unless their number changes, the
  /// same points; else a record with fewer than another has no numbers at its end. Throws FileError.
  void append(const FieldsInTurn& snapshot);
  void close();

 private:
  std::filesystem::path folder_;
  Provenance provenance_;
  bool changing_;
  VtkSeries vtk_;
  std::optional<SnapshotFile> file_;
};

}  // namespace tether
