// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "grid/mesh.hpp"
#include "results/results.hpp"
#include "results/snapshot_file.hpp"
#include "results/vtk_series.hpp"

namespace tether {

/// Writes NAME.nc, fields over (time, node) of a mesh of finite elements by the UGRID conventions (1.0, with places of
/// the reference shape; the fields x, y, z are where the nodes are at a time). As PointWriter.
class MeshWriter {
 public:
  MeshWriter(std::filesystem::path folder, std::string name, Provenance provenance, VtkFiles vtk = VtkFiles::automatic);
  /// The snapshot's first fields are the places of the nodes; mesh and fields are the same every time. Throws
  /// FileError.
  void append(const Mesh& mesh, const Snapshot& snapshot);
  void close();

 private:
  std::filesystem::path folder_;
  std::string name_;
  Provenance provenance_;
  VtkSeries vtk_;
  std::optional<SnapshotFile> file_;
};

}  // namespace tether
