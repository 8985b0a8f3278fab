// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "laws/fluids.hpp"
#include "loops/points.hpp"
#include "physics/points/arrays.hpp"

namespace tether::mpm {

/// Mass of gas per cell, for the densities that come from cells (4.5), (4.6). The array has a ring of cells around the
/// grid; behind a wall that mirrors, the ring's mass is the image of what lies before it and belongs to the edge cell.
class CellDensity {
 public:
  CellDensity(const Frame& frame, const Walls& walls, Geometry geometry, DensityRule rule,
              const Strip* strip = nullptr);

  /// Sets P.rho of the points in `takers` from the present places of all gas, whatever body it belongs to.
  void update(Points& points, const std::vector<Slots>& gas, const std::vector<Slots>& takers);
  /// Density of a cell of the frame at the last update, (i, j) from 0 [mass/volume].
  double operator()(int i, int j) const;

 private:
  std::size_t index(int i, int j) const {
    const int row = j + 1, column = i + 1;  // -1 is the ring
    return row_[static_cast<std::size_t>(row)] + column_[static_cast<std::size_t>(column)];
  }
  void clear(const Points& points, const std::vector<Slots>& gas);
  void clear_around(const Points& points, Slots range);
  void add(const Points& points, Slots range);
  void add_cell(const Points& points, Slots range);
  void add_quadratic(const Points& points, Slots range);
  template <int across>
  void add_along_the_strip(const Points& points, Slots range);

  Locator locator_;
  DensityRule rule_;
  int across_ = -1;                        // axis across a strip that runs as one row
  std::vector<std::size_t> column_, row_;  // where cell i (j), from -1 on, stands in mass_
  std::vector<double> volume_;             // of a cell of column i, about an axis 2 pi r dx dy [volume]
  std::vector<double> mass_;
};

}  // namespace tether::mpm
