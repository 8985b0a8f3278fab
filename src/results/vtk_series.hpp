// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "fields/fields_in_turn.hpp"
#include "grid/boxes.hpp"
#include "grid/mesh.hpp"
#include "model/scene.hpp"
#include "results/results.hpp"
#include "results/snapshot_file.hpp"
#include "results/vtk_file.hpp"

namespace tether {

/// Numbers of an element's nodes in the order in which VTK, XDMF and UGRID count them: corners around, first below; of
/// order 2 then the middles of edges and faces, and the centre.
std::vector<int> vtk_order(ElementKind kind);

/// The first `count` nodes of each element in that order, element by element.
std::vector<std::int32_t> nodes_in_vtk_order(const Mesh& mesh, std::size_t count);

/// Points as they are, each a cell of its own.
VtkShape vtk_of_points(std::size_t count);

/// Points of which so many in turn are the corners of an edge or a polygon.
VtkShape vtk_of_facets(std::size_t count, int corners);

/// Points of which three in turn are the corners of a triangle, or four of a tetrahedron.
VtkShape vtk_of_simplices(std::size_t count, int corners);

/// A mesh of finite elements, with the region of each.
VtkShape vtk_of_mesh(const Mesh& mesh);

/// The nodes of a background grid, and the cells of a box.
VtkShape vtk_of_nodes(const BackgroundGrid& grid);
VtkShape vtk_of_cells(const StaggeredGrid& grid);

/// The folder beside the NetCDF files that VTK files stand in.
inline constexpr const char* vtk_folder = "vtk";

/// The snapshots of one NetCDF file as VTK files, vtk/NAME-0000.ENDING and so on, and NAME.pvd, by which ParaView opens
/// them with their times.
class VtkSeries {
 public:
  /// Nothing is created before the first snapshot.
  VtkSeries(std::filesystem::path folder, std::string name, std::string ending, VtkFiles wanted);

  /// Appends a snapshot to the NetCDF file and, where VTK files are wanted, writes one of it; room for it is there
  /// before the NetCDF file changes. Throws FileError.
  void append(SnapshotFile& file, const std::function<VtkShape()>& shape, const FieldsInTurn& snapshot);

 private:
  std::filesystem::path folder_;
  std::string name_, ending_;
  VtkFiles wanted_;
  std::vector<double> times_;
};

}  // namespace tether
