// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "grid/boxes.hpp"
#include "grid/mesh.hpp"
#include "results/results.hpp"

namespace tether {

/// The records of a snapshot file that an XDMF text points into.
struct XdmfSeries {
  std::string file;                 ///< the NetCDF-4 file, beside the text
  std::vector<std::string> fields;  ///< names of its variables over time and points (or nodes)
  std::vector<double> times;        ///< of the records
};

/// XDMF version 2, which ParaView's "XDMF Reader" reads (its Xdmf3 readers do not): the points of each record, so many,
/// at the fields x and y.
std::string xdmf_points(const XdmfSeries& series, const std::vector<std::size_t>& counts);

/// The same for fields over time, node_y, node_x on the nodes of a background grid.
std::string xdmf_grid(const XdmfSeries& series, const BackgroundGrid& grid);

/// The same for fields over time and the nodes of a mesh of finite elements, drawn at the fields x, y (and z); the file
/// has their nodes as `element_nodes`, in the order of vtk_order().
std::string xdmf_mesh(const XdmfSeries& series, const Mesh& mesh);

}  // namespace tether
