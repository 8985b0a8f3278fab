// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <span>
#include <vector>

#include "algebra/eigen_sparse.hpp"
#include "base/team.hpp"
#include "grid/solid_surface.hpp"

namespace tether::coupled {

/// Rows are pressures, columns velocities of the solids' nodes, dim a node.
using CouplingMatrix = EigenRows;

/// What one side of the surface has in one row of a coupling matrix: at the side's node a and the axis i number
/// 3 a + i.
struct SideEntry {
  int row = 0, side = 0;
  std::array<double, 9> value{};
};

/// Sums entries of a matrix side by side: the many that the points of one side give the same place become one.
class SideSums {
 public:
  /// Entries from now on are this side's.
  void begin(int side) {
    if (side != side_) flush();
    side_ = side;
  }
  /// The sums of a row, of the present side; valid until the next call.
  std::array<double, 9>& row(int row) { return rows_[row]; }
  /// All of them, side by side, the rows of a side ascending.
  std::vector<SideEntry> take() {
    flush();
    return std::move(entries_);
  }

 private:
  void flush() {
    for (const auto& [row, value] : rows_) entries_.push_back({row, side_, value});
    rows_.clear();
  }

  int side_ = -1;
  std::map<int, std::array<double, 9>> rows_;
  std::vector<SideEntry> entries_;
};

/// The matrix that lists of entries add up to, one list after the other.
CouplingMatrix matrix_of_sides(Team& team, const SolidSurface& surface, std::span<const std::vector<SideEntry>> lists,
                               std::size_t rows, std::size_t columns);

}  // namespace tether::coupled
