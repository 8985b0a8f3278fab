// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/mpm/arrays.hpp"

#include <algorithm>
#include <numeric>

namespace tether::mpm {
namespace {

std::vector<std::uint8_t> held_nodes(const BackgroundGrid& grid, const Walls& walls) {
  std::vector<std::uint8_t> held(grid.nodes(), holds_none);
  const auto nx = static_cast<std::size_t>(grid.nx), ny = static_cast<std::size_t>(grid.ny);
  for (std::size_t j = 0; j < ny; ++j) {
    held[j * nx] |= held_by(walls.left, holds_x);
    held[j * nx + nx - 1] |= held_by(walls.right, holds_x);
  }
  for (std::size_t i = 0; i < nx; ++i) {
    held[i] |= held_by(walls.bottom, holds_y);
    held[(ny - 1) * nx + i] |= held_by(walls.top, holds_y);
  }
  return held;
}

}  // namespace

Points::Points(const PointSet& initial)
    : x(initial.x),
      y(initial.y),
      vx(initial.vx),
      vy(initial.vy),
      mass(initial.mass),
      volume(initial.volume),
      sxx(initial.sxx),
      syy(initial.syy),
      sxy(initial.sxy),
      id(initial.size()) {
  for (auto* array : {&rho, &energy, &strain, &tx, &ty, &dxx, &dyy, &dxy}) array->assign(initial.size(), 0.0);
  std::iota(id.begin(), id.end(), 0);
}

Grid::Grid(const BackgroundGrid& shape_, const Walls& walls, std::size_t points)
    : shape(shape_),
      sums(shape_.nodes()),
      motion(shape_.nodes()),
      convected(shape_.nodes()),
      held(held_nodes(shape_, walls)),
      cell_stamp(shape_.cells(), 0),
      node_stamp(shape_.nodes(), 0) {
  active_cells.reserve(std::min(points, shape.cells()));
  active_nodes.reserve(std::min(4 * points, shape.nodes()));
}

void Grid::list_active(const Points& points) {
  const Locator locator(shape);
  const int nx = shape.nx;
  active_cells.clear();
  active_nodes.clear();
  ++stamp;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const CellPlace at = locator.locate(points.x[p], points.y[p]);
    const int cell = at.j * (nx - 1) + at.i;
    auto& listed = cell_stamp[static_cast<std::size_t>(cell)];
    if (listed == stamp) continue;
    listed = stamp;
    active_cells.push_back(cell);
    const int node = at.j * nx + at.i;
    for (const int corner : {node, node + 1, node + nx, node + nx + 1}) {
      auto& node_listed = node_stamp[static_cast<std::size_t>(corner)];
      if (node_listed != stamp) active_nodes.push_back(corner);
      node_listed = stamp;
    }
  }
}

}  // namespace tether::mpm
