// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>

namespace tether {

/// The regular background grid: nx by ny NODES from (x0, y0), cells of dx by dy. Node (i, j) is number j nx + i,
/// cell (i, j) has node (i, j) at its lower left and is number j (nx - 1) + i; both count from 0.
struct BackgroundGrid {
  int nx = 2, ny = 2;
  double x0 = 0, y0 = 0;  // [length]
  double x1 = 1, y1 = 1;  // [length]
  double dx = 1, dy = 1;  // [length]

  BackgroundGrid() = default;
  BackgroundGrid(int nodes_x, int nodes_y, double left, double right, double bottom, double top)
      : nx(nodes_x),
        ny(nodes_y),
        x0(left),
        y0(bottom),
        x1(right),
        y1(top),
        dx((right - left) / (nodes_x - 1)),
        dy((top - bottom) / (nodes_y - 1)) {}

  bool operator==(const BackgroundGrid&) const = default;

  int cells_x() const { return nx - 1; }
  int cells_y() const { return ny - 1; }
  std::size_t nodes() const { return static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny); }
  std::size_t cells() const { return static_cast<std::size_t>(nx - 1) * static_cast<std::size_t>(ny - 1); }
  /// The right and the top edge belong to the grid. False for NaN.
  bool contains(double x, double y) const { return x >= x0 && x <= x1 && y >= y0 && y <= y1; }
};

/// The cell that holds a place, and the place's logical coordinates in it, r and s from 0 to 1 (A.3.1).
struct CellPlace {
  int i = 0, j = 0;
  double r = 0, s = 0;
};

/// What locate() needs, with the divisions done once.
struct Locator {
  double x0, y0, per_dx, per_dy;
  int last_i, last_j, nx;

  explicit Locator(const BackgroundGrid& grid)
      : x0(grid.x0),
        y0(grid.y0),
        per_dx(1 / grid.dx),
        per_dy(1 / grid.dy),
        last_i(grid.nx - 2),
        last_j(grid.ny - 2),
        nx(grid.nx) {}

  /// Part of a cell by which a place on a cell's edge counts as inside. The nodes across the cell then still learn the
  /// place's velocity (their mass would be 0 otherwise, and the gradient wrong), and no nodal mass is ever so small
  /// that its quotients overflow.
  static constexpr double edge = 1e-12;

  /// The place must lie inside the grid. A place on the right or top edge belongs to the last cell.
  CellPlace locate(double x, double y) const {
    const double a = (x - x0) * per_dx, b = (y - y0) * per_dy;
    const int i = std::min(static_cast<int>(a), last_i), j = std::min(static_cast<int>(b), last_j);
    return {i, j, inside(a - i), inside(b - j)};
  }
  static double inside(double r) { return std::min(std::max(r, edge), 1 - edge); }
  std::size_t lower_left_node(const CellPlace& at) const {
    return static_cast<std::size_t>(at.j) * static_cast<std::size_t>(nx) + static_cast<std::size_t>(at.i);
  }
};

}  // namespace tether
