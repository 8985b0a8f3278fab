// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include "grid/background_grid.hpp"
#include "results/results.hpp"
#include "results/snapshot_file.hpp"
#include "results/xdmf.hpp"

namespace tether {

/// Writes particles.nc, fields over (time, point), and particles.xmf, by which ParaView opens it. Nothing is created
/// before the first snapshot; each one is with the system, and the .xmf whole, before append() returns.
/// While the run goes on its NetCDF-4 files are locked by HDF5; who wants to read them then sets
/// HDF5_USE_FILE_LOCKING=FALSE.
class PointWriter {
 public:
  /// `changing`: how many points there are.
  PointWriter(std::filesystem::path folder, Provenance provenance, bool changing = false);
  /// The snapshot has the fields `x` and `y`, and the same fields every time, and, unless their number changes, the
  /// same points; else a record with fewer than another has no numbers at its end. Throws FileError.
  void append(const Snapshot& snapshot);
  void close();

 private:
  std::filesystem::path folder_;
  Provenance provenance_;
  bool changing_;
  std::vector<std::size_t> counts_;  // of points in each record
  XdmfSeries series_;
  std::optional<SnapshotFile> file_;
};

/// Writes mesh.nc, fields over (time, node_y, node_x) with the coordinates of the nodes, and mesh.xmf. As PointWriter.
class GridWriter {
 public:
  GridWriter(std::filesystem::path folder, Provenance provenance);
  /// The grid is the same every time (else std::invalid_argument). Throws FileError.
  void append(const BackgroundGrid& grid, const Snapshot& snapshot);
  void close();

 private:
  std::filesystem::path folder_;
  Provenance provenance_;
  BackgroundGrid grid_;
  XdmfSeries series_;
  std::optional<SnapshotFile> file_;
};

}  // namespace tether
