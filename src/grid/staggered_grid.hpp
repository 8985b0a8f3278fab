// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "base/index.hpp"
#include "grid/mesh.hpp"

namespace tether {

/// Equal cells that fill a box, with pressures at their middles and on their faces the velocities across them (Harlow
/// and Welch). In the plane there is one layer of cells, of depth 1, and no face across it. Cell (i, j, k) is number
/// i + n0 (j + n1 k); faces across axis a are those of a lattice that has one more along a, face (i, j, k) at the lower
/// side of cell (i, j, k).
struct StaggeredGrid {
  int dim = 2;
  std::array<int, 3> n{1, 1, 1};       ///< cells along each axis
  std::array<double, 3> low{0, 0, 0};  ///< the box's lowest corner [length]
  std::array<double, 3> d{1, 1, 1};    ///< a cell's sides [length]

  bool operator==(const StaggeredGrid&) const = default;

  double high(int axis) const { return low[at(axis)] + n[at(axis)] * d[at(axis)]; }
  double volume() const { return d[0] * d[1] * d[2]; }            ///< of a cell
  double area(int axis) const { return volume() / d[at(axis)]; }  ///< of a face across the axis
  double middle(int axis, int i) const { return low[at(axis)] + (i + 0.5) * d[at(axis)]; }
  /// A cell's middle; z is 0 in the plane.
  std::array<double, 3> middle(const std::array<int, 3>& c) const {
    return {middle(0, c[0]), middle(1, c[1]), dim == 3 ? middle(2, c[2]) : 0};
  }
  double face_place(int axis, int i) const { return low[at(axis)] + i * d[at(axis)]; }

  std::size_t cell_count() const { return at(n[0]) * at(n[1]) * at(n[2]); }
  std::size_t cell(int i, int j, int k) const { return at(i) + at(n[0]) * (at(j) + at(n[1]) * at(k)); }
  std::size_t cell(const std::array<int, 3>& c) const { return cell(c[0], c[1], c[2]); }
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

 private:
};

/// A mesh whose nodes are the cells' middles, for what is drawn.
Mesh mesh_of_middles(const StaggeredGrid& grid);

}  // namespace tether
