// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "base/vec.hpp"
#include "grid/boxes.hpp"

namespace tether::liquid {

/// Where a place is on a lattice of points a cell apart: the lowest corner of the box of lattice points about it, and
/// how far it is from that corner, from 0 to 1 on each axis.
template <std::size_t dim>
struct LatticePlace {
  std::array<int, dim> low;
  std::array<double, dim> part;
};

/// Which sides of the box hold what flows along them: left, right, bottom, top, back and front.
using HeldSides = std::array<bool, 6>;

/// A lattice of the grid: middles of the faces across an axis, or middles of cells.
template <std::size_t dim>
class Lattice {
 public:
  static constexpr std::size_t corners = std::size_t{1} << dim;

  /// The faces across `axis`; -1: the cells.
  Lattice(const StaggeredGrid& grid, int axis) {
    for (std::size_t b = 0; b < dim; ++b) {
      const bool across = static_cast<int>(b) == axis;
      size[b] = grid.n[b] + (across ? 1 : 0);
      low_[b] = grid.low[b] + (across ? 0 : 0.5) * grid.d[b], per_d_[b] = 1 / grid.d[b];
      stride[b] = b == 0 ? 1 : stride[b - 1] * size[b - 1];
    }
  }

  LatticePlace<dim> locate(const std::array<double, dim>& x) const {
    LatticePlace<dim> place;
    constexpr int below = 4;  // so that numbers are cut off downwards
    for (std::size_t b = 0; b < dim; ++b) {
      const double at = (x[b] - low_[b]) * per_d_[b];
      place.low[b] = static_cast<int>(at + below) - below;
      place.part[b] = at - place.low[b];
    }
    return place;
  }
  /// Finds it within the lattice: what is beyond its last points belongs to these.
  LatticePlace<dim> locate_within(const std::array<double, dim>& x) const {
    LatticePlace<dim> place;
    for (std::size_t b = 0; b < dim; ++b) {
      const double at = std::clamp((x[b] - low_[b]) * per_d_[b], 0.0, size[b] - 1.0);
      place.low[b] = std::min(static_cast<int>(at), size[b] - 2);
      place.part[b] = at - place.low[b];
    }
    return place;
  }
  /// How far a place is beyond the last points along an axis, below 0 before the first one [cells].
  double beyond(const std::array<double, dim>& x, std::size_t b) const {
    const double at = (x[b] - low_[b]) * per_d_[b];
    return at - std::clamp(at, 0.0, size[b] - 1.0);
  }
  /// The part of the last points' velocity that is left at a place beyond them: none at sides that hold it, half a cell
  /// away.
  double left_by_walls(const std::array<double, dim>& x, const HeldSides& held) const {
    double part = 1;
    for (std::size_t b = 0; b < dim; ++b) {
      const double cells = beyond(x, b);
      if (held[2 * b + (cells > 0 ? 1 : 0)]) part *= 1 - 2 * std::abs(cells);
    }
    return part;
  }
  std::ptrdiff_t number(const std::array<int, dim>& point) const {
    std::ptrdiff_t n = 0;
    for (std::size_t b = 0; b < dim; ++b) n += stride[b] * point[b];
    return n;
  }
  /// Interpolates linearly along each axis.
  double between(const double* values, const std::array<double, dim>& x) const {
    const LatticePlace<dim> place = locate_within(x);
    const double* first = values + number(place.low);
    std::array<double, corners> value;
    for (std::size_t corner = 0; corner < corners; ++corner) value[corner] = first[step(corner)];
    std::size_t left = corners / 2;
    for (std::size_t b = 0; b < dim; ++b, left /= 2) {
      for (std::size_t k = 0; k < left; ++k)
        value[k] = value[2 * k] + place.part[b] * (value[2 * k + 1] - value[2 * k]);
    }
    return value[0];
  }
  /// The hat's weight of a corner, bit b of whose number says whether it is the upper one along axis b.
  static double weight(const LatticePlace<dim>& place, std::size_t corner) {
    double w = 1;
    for (std::size_t b = 0; b < dim; ++b) w *= (corner >> b & 1) != 0 ? place.part[b] : 1 - place.part[b];
    return w;
  }
  /// Returns whether the lattice has a corner of the box about a place, or all of them.
  bool has(const LatticePlace<dim>& place, std::size_t corner) const {
    bool within = true;
    for (std::size_t b = 0; b < dim; ++b) {
      const int i = place.low[b] + static_cast<int>(corner >> b & 1);
      within = within && i >= 0 && i < size[b];
    }
    return within;
  }
  bool has_all_about(const LatticePlace<dim>& place) const { return has(place, 0) && has(place, corners - 1); }
  std::ptrdiff_t step(std::size_t corner) const {
    std::ptrdiff_t n = 0;
    for (std::size_t b = 0; b < dim; ++b) n += (corner >> b & 1) != 0 ? stride[b] : 0;
    return n;
  }

  std::array<int, dim> size;
  std::array<std::ptrdiff_t, dim> stride;

 private:
  std::array<double, dim> low_, per_d_;
};

}  // namespace tether::liquid
