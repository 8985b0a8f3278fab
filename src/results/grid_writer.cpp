// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/grid_writer.hpp"

#include <stdexcept>

namespace tether {
namespace {

/// Nodes along one direction, from 0: first + k step.
Axis nodes(const char* name, char direction, int count, double first, double step) {
  Axis axis{name, static_cast<std::size_t>(count), {}, false, direction};
  for (int k = 0; k < count; ++k) axis.places.push_back(first + k * step);
  return axis;
}

/// Middles of the cells along one direction.
Axis cells(const StaggeredGrid& grid, int direction) {
  const char letter = "xyz"[direction];
  Axis axis{std::string(1, letter), at(grid.n[at(direction)]), {}, false, "XYZ"[direction], grid.d[at(direction)]};
  for (int k = 0; k < grid.n[at(direction)]; ++k) axis.places.push_back(grid.middle(direction, k));
  return axis;
}

/// The axes of the fields, slowest first.
struct AxesOf {
  std::vector<Axis> operator()(const BackgroundGrid& grid) const {
    return {nodes("node_y", 'Y', grid.ny, grid.y0, grid.dy), nodes("node_x", 'X', grid.nx, grid.x0, grid.dx)};
  }
  std::vector<Axis> operator()(const StaggeredGrid& grid) const {
    std::vector<Axis> axes;
    for (int direction = grid.dim - 1; direction >= 0; --direction) axes.push_back(cells(grid, direction));
    return axes;
  }
};

struct VtkOf {
  VtkShape operator()(const BackgroundGrid& grid) const { return vtk_of_nodes(grid); }
  VtkShape operator()(const StaggeredGrid& grid) const { return vtk_of_cells(grid); }
};

}  // namespace

GridWriter::GridWriter(std::filesystem::path folder, Provenance provenance, VtkFiles vtk)
    : folder_(std::move(folder)), provenance_(std::move(provenance)), vtk_(folder_, "mesh", "vti", vtk) {}

void GridWriter::append(const RegularGrid& grid, const FieldsInTurn& snapshot) {
  if (!file_) {
    file_.emplace(folder_ / "mesh.nc", std::visit(AxesOf{}, grid), snapshot, provenance_);
    grid_ = grid;
  }
  if (!(grid == grid_)) throw std::invalid_argument("the grid of the snapshots has changed");
  vtk_.append(
      *file_, [&] { return std::visit(VtkOf{}, grid); }, snapshot);
}

void GridWriter::close() {
  if (file_) file_->close();
}

}  // namespace tether
