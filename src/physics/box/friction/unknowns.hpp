// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "base/numbers.hpp"
#include "grid/boxes.hpp"

namespace tether::coupled {

/// How the velocities of faces and those of the solids' nodes stand in one row of numbers while friction acts.
///
/// The faces across each axis stand on a lattice of places that is the same for all axes, one place more than there are
/// cells along each: face (i, j, k) is at place (i, j, k), as are cell (i, j, k) and the edges at its lower corner.
/// Numbers that belong to nothing stand before and after each lattice, so that what is next to any place has a number.
struct FrictionUnknowns {
  FrictionUnknowns(const StaggeredGrid& box, std::size_t numbers_of_nodes)
      : grid(box), size{box.n[0] + 1, box.n[1] + 1, box.dim == 3 ? box.n[2] + 1 : 1}, nodes(numbers_of_nodes) {
    stride = {1, at(size[0]), at(size[0]) * at(size[1])};
    margin = stride[at(grid.dim) - 1];
    places = stride[2] * at(size[2]);
  }

  /// The number of a place on a lattice that stands alone.
  std::size_t place(const std::array<int, 3>& p) const {
    return margin + at(p[0]) + stride[1] * at(p[1]) + stride[2] * at(p[2]);
  }
  std::size_t lattice() const { return places + 2 * margin; }
  std::size_t face(int axis, const std::array<int, 3>& p) const { return at(axis) * lattice() + place(p); }
  /// A node's number k, of all those that nodes have.
  std::size_t node(std::size_t k) const { return at(grid.dim) * lattice() + k; }
  std::size_t count() const { return node(nodes); }

  const StaggeredGrid& grid;
  std::array<int, 3> size;              ///< places along each axis
  std::array<std::size_t, 3> stride{};  ///< from a place to the next one along each axis
  std::size_t margin = 0, places = 0, nodes = 0;
};

/// The place so many farther along an axis.
inline std::array<int, 3> moved(std::array<int, 3> place, int axis, int by) {
  place[at(axis)] += by;
  return place;
}

/// A sum of unknowns times factors, such as the slope of a velocity.
struct Combination {
  static constexpr std::size_t most = 16;
  std::array<std::size_t, most> unknown{};
  std::array<double, most> factor{};
  std::size_t size = 0;

  void add(std::size_t number, double by) {
    unknown[size] = number;
    factor[size++] = by;
  }
  void add(const Combination& other, double by) {
    for (std::size_t k = 0; k < other.size; ++k) add(other.unknown[k], by * other.factor[k]);
  }
};

}  // namespace tether::coupled
