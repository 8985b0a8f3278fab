// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <variant>

#include "fields/fields_in_turn.hpp"
#include "grid/boxes.hpp"
#include "results/results.hpp"
#include "results/snapshot_file.hpp"
#include "results/vtk_series.hpp"

namespace tether {

/// A regular grid that fields stand on: the nodes of a background grid, or the cells of a box.
using RegularGrid = std::variant<BackgroundGrid, StaggeredGrid>;

/// Writes mesh.nc, fields over (time, node_y, node_x) of nodes, or (time, z, y, x) of cells, with the places of the
/// nodes, or the middles and bounds of the cells, by the CF conventions. As PointWriter.
class GridWriter {
 public:
  GridWriter(std::filesystem::path folder, Provenance provenance, VtkFiles vtk = VtkFiles::automatic);
  /// The grid is the same every time (else std::invalid_argument). Throws FileError.
  void append(const RegularGrid& grid, const FieldsInTurn& snapshot);
  void close();

 private:
  std::filesystem::path folder_;
  Provenance provenance_;
  RegularGrid grid_;
  VtkSeries vtk_;
  std::optional<SnapshotFile> file_;
};

}  // namespace tether
