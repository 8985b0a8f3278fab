// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <numbers>

#include "base/numbers.hpp"
#include "base/vec.hpp"
#include "grid/mesh.hpp"

namespace tether {

/// What a plane scene stands for: a slab one unit deep, or a body of revolution, x the radius and y the axis.
enum class Geometry { plane, axisymmetric };

/// Depth of the scene at x: 1, or the way round 2 pi r; volumes, masses and energies are whole ones [length].
inline double depth(Geometry geometry, double x) {
  return geometry == Geometry::plane ? 1.0 : 2 * std::numbers::pi * x;
}

/// An x and a y component that the processor handles as one: the width every x86-64 has. Componentwise + - * with
/// pairs and with plain numbers.
using Pair = double __attribute__((vector_size(16)));

inline Pair pair(double x, double y) { return Pair{x, y}; }

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
  [[gnu::always_inline]] inline CellPlace locate(double x, double y) const {
    const double a = (x - x0) * per_dx, b = (y - y0) * per_dy;
    const int i = std::min(static_cast<int>(a), last_i), j = std::min(static_cast<int>(b), last_j);
    return {i, j, inside(a - i), inside(b - j)};
  }
  static double inside(double r) { return std::min(std::max(r, edge), 1 - edge); }
  std::size_t lower_left_node(const CellPlace& at) const {
    return static_cast<std::size_t>(at.j) * static_cast<std::size_t>(nx) + static_cast<std::size_t>(at.i);
  }
};

/// Equal cells that fill a box, with pressures at their middles and on their faces the velocities across them (Harlow
/// and Welch). In the plane there is one layer of cells, of depth 1, and no face across it. Cell (i, j, k) is number
/// i + n0 (j + n1 k); faces across axis a are those of a lattice that has one more along a, face (i, j, k) at the lower
/// side of cell (i, j, k).
struct StaggeredGrid {
  int dim = 2;
  std::array<int, 3> n{1, 1, 1};  ///< cells along each axis
  Vec<3> low{0, 0, 0};            ///< the box's lowest corner [length]
  Vec<3> d{1, 1, 1};              ///< a cell's sides [length]

  bool operator==(const StaggeredGrid&) const = default;

  double high(int axis) const { return low[at(axis)] + n[at(axis)] * d[at(axis)]; }
  Box<3> box() const { return {low, {high(0), high(1), high(2)}}; }
  double volume() const { return d[0] * d[1] * d[2]; }            ///< of a cell
  double area(int axis) const { return volume() / d[at(axis)]; }  ///< of a face across the axis
  double middle(int axis, int i) const { return low[at(axis)] + (i + 0.5) * d[at(axis)]; }
  /// A cell's middle; z is 0 in the plane.
  Vec<3> middle(const std::array<int, 3>& c) const {
    return {middle(0, c[0]), middle(1, c[1]), dim == 3 ? middle(2, c[2]) : 0};
  }
  double face_place(int axis, int i) const { return low[at(axis)] + i * d[at(axis)]; }

  std::size_t cell_count() const { return at(n[0]) * at(n[1]) * at(n[2]); }
  std::size_t cell(int i, int j, int k) const { return at(i) + at(n[0]) * (at(j) + at(n[1]) * at(k)); }
  std::size_t cell(const std::array<int, 3>& c) const { return cell(c[0], c[1], c[2]); }
  /// How far the next cell along an axis is in number.
  std::size_t stride(int axis) const { return axis == 0 ? 1 : axis == 1 ? at(n[0]) : at(n[0]) * at(n[1]); }
  std::array<int, 3> place_of_cell(std::size_t c) const {
    const std::size_t row = c / at(n[0]);
    return {int(c % at(n[0])), int(row % at(n[1])), int(row / at(n[1]))};
  }

  std::array<int, 3> faces(int axis) const {
    std::array<int, 3> m = n;
    ++m[at(axis)];
    return m;
  }
  std::size_t face_count(int axis) const {
    const auto m = faces(axis);
    return at(m[0]) * at(m[1]) * at(m[2]);
  }
  std::size_t face(int axis, int i, int j, int k) const {
    const auto m = faces(axis);
    return at(i) + at(m[0]) * (at(j) + at(m[1]) * at(k));
  }
  std::size_t face(int axis, const std::array<int, 3>& f) const { return face(axis, f[0], f[1], f[2]); }
  std::array<int, 3> place_of_face(int axis, std::size_t f) const {
    const auto m = faces(axis);
    const std::size_t row = f / at(m[0]);
    return {int(f % at(m[0])), int(row % at(m[1])), int(row / at(m[1]))};
  }
  bool has_cell(const std::array<int, 3>& c) const {
    return c[0] >= 0 && c[0] < n[0] && c[1] >= 0 && c[1] < n[1] && c[2] >= 0 && c[2] < n[2];
  }
};

}  // namespace tether
