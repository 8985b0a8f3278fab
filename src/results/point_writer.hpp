// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include "fields/fields_in_turn.hpp"
#include "results/results.hpp"
#include "results/snapshot_file.hpp"
#include "results/vtk_series.hpp"

namespace tether {

/// What the points of a file are: each for itself, or so many in turn the corners of a facet or a cell.
struct PointKind {
  const char* file = "particles";  ///< its name without an ending
  const char* axis = "point";
  int corners = 1;             ///< of a facet; 1: there are none
  const char* ending = "vtp";  ///< of VTK files: "vtu" where facets are cells that fill their space
};
inline constexpr PointKind particles_file{}, edges_file{"surface", "corner", 2}, triangles_file{"surface", "corner", 3},
    flow_triangles_file{"flow", "corner", 3, "vtu"}, flow_tetrahedra_file{"flow", "corner", 4, "vtu"};

/// Writes particles.nc, surface.nc or flow.nc, fields over (time, point), and where they are wanted VTK files as well.
/// Nothing is created before the first snapshot; each one is with the system before append() returns. While the run
/// goes on its NetCDF-4 files are locked by HDF5; who wants to read them then sets HDF5_USE_FILE_LOCKING=FALSE.
class PointWriter {
 public:
  /// `changing`: how many points there are.
  PointWriter(std::filesystem::path folder, Provenance provenance, VtkFiles vtk = VtkFiles::automatic,
              bool changing = false, const PointKind& kind = particles_file);
  /// The snapshot has the fields `x` and `y`, and the same fields every time, and, unless their number changes, the
  /// same points; else a record with fewer than another has no numbers at its end. Throws FileError.
  void append(const FieldsInTurn& snapshot);
  void close();

 private:
  std::filesystem::path folder_;
  Provenance provenance_;
  bool changing_;
  PointKind kind_;
  VtkSeries vtk_;
  std::optional<SnapshotFile> file_;
};

}  // namespace tether
