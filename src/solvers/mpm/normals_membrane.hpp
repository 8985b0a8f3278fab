// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "solvers/mpm/normals_cells.hpp"
#include "solvers/mpm/normals_fit.hpp"
#include "solvers/mpm/normals_profile.hpp"

namespace tether::mpm {

/// The mass matrix method with one matrix for the whole membrane (7.12). Cells share colours, so the extra points, one
/// a cell, must agree: each has as its colour its height above the line nearest to its cell's points, counted to the
/// left of the tangents of before: the colour comes out as a distance from the membrane. A point that is alone in its
/// cell takes the direction of its extra point from the ghost cell (Fig. 88).
template <class Color>
class MembraneMatrixNormals {
 public:
  MembraneMatrixNormals(const BackgroundGrid& shape, const Walls& walls, std::size_t most_points);
  void update(const PlaceArrays& places, Range membrane, const Tangents& tangents);

 private:
  using Cell = MembraneCells::Cell;
  using Row = typename Color::Row;
  using Block = std::array<Row, Color::count>;
  using Unknowns = std::array<std::size_t, Color::count>;

  Unknowns keys_of(const Cell& cell) const;
  void number_unknowns();
  void visit_around(std::size_t seed);
  void number(std::size_t cell);
  void set_profile();
  void solve(const Tangents& tangents);
  void assemble(std::size_t cell, const Tangents& tangents);
  NearestLine line_of(const Cell& cell);
  void add_extra(const Cell& cell, const Tangents& tangents, Block& block, Row& right);
  bool stiffen_what_turns_round();
  void gradients_of(std::size_t cell);

  BackgroundGrid shape_;
  MembraneCells cells_;
  Block stiffness_{};
  std::vector<std::size_t> keys_, numbers_, order_, first_;  // of the colours' places, and their numbers as unknowns
  std::vector<unsigned char> reached_;                       // cells that stand in order_
  std::vector<Unknowns> unknowns_;                           // by cell
  std::vector<double> factors_;                              // of its stiffness
  std::size_t numbered_ = 0;
  ProfileMatrix matrix_;
  std::vector<double> colors_;
  std::vector<LocalPlace> cell_places_, ghost_places_;
  std::vector<Pair> gradients_;  // of a cell's points
};

}  // namespace tether::mpm
