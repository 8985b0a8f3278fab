// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "grid/background_grid.hpp"
#include "laws/walls/walls.hpp"
#include "loops/points.hpp"
#include "model/method.hpp"
#include "solvers/mpm/normals_colors.hpp"
#include "solvers/mpm/normals_points.hpp"

namespace tether::mpm {

/// A membrane's points by cell.
class MembraneCells {
 public:
  struct Member {
    CellPlace at;
    std::size_t point;
  };
  struct Cell {
    int i, j;
    std::size_t begin, end;  // of its members
  };

  MembraneCells(const BackgroundGrid& shape, const Walls& walls, std::size_t most_points);
  void sort(const PlaceArrays& places, Range membrane);

  std::span<const Cell> cells() const { return cells_; }
  std::span<const Member> members(const Cell& cell) const {
    return std::span(members_).subspan(cell.begin, cell.end - cell.begin);
  }
  /// Null where the cell holds no point of the membrane.
  const Cell* find(int i, int j) const;
  /// Places in four cells as one (Fig. 88), the two by two that are nearest to the first point of `cell`: first its own
  /// points, then the others, and images behind a mirror.
  void ghost_places(const Cell& cell, std::vector<LocalPlace>& places) const;

 private:
  BackgroundGrid shape_;
  bool left_, right_, bottom_, top_;  // mirrors
  std::vector<Member> members_;
  std::vector<Cell> cells_;
};

/// The mass matrix method cell by cell (7.8)-(7.14), (7.18), (7.19). It sees only which points share a cell: two sheets
/// of one membrane in a cell come out as one, and two points of a curve have their chord's normal.
template <class Color>
class CellMatrixNormals {
 public:
  CellMatrixNormals(const BackgroundGrid& shape, const Walls& walls, LonePoint alone, std::size_t most_points);
  void update(const PlaceArrays& places, Range membrane, const Tangents& tangents);

 private:
  using Cell = MembraneCells::Cell;
  void fit_cell(const Cell& cell, const Tangents& tangents);
  void fit_ghost(const Cell& cell, const Tangents& tangents);

  double dx_, dy_;
  LonePoint alone_;
  MembraneCells cells_;
  std::vector<LocalPlace> places_;
  std::vector<Pair> gradients_;
};

}  // namespace tether::mpm
