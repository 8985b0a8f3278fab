// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "grid/background_grid.hpp"
#include "grid/pair.hpp"
#include "laws/walls/walls.hpp"
#include "loops/points.hpp"
#include "solvers/mpm/folds.hpp"
#include "solvers/mpm/normals_points.hpp"

// Normals from a colour that points lend to the grid (7.1 to 7.3 of chapter 7). All points have the colour 1, those of
// the membrane and the others, of the fluid inside. Without fluid the colour has its ridge on the membrane, where its
// gradient vanishes but for the scatter of the points: that is why the results are then poor.

namespace tether::mpm {

/// Shorter gradients of the colours of single points, times a cell's side, are rounding.
constexpr double least_color_slope = 1e-9;

/// Colour of cells by the quadratic kernel, and its gradient at nodes. Behind a wall that mirrors stands the image.
class CellColor {
 public:
  CellColor(const BackgroundGrid& shape, const Walls& walls);

  void clear() { color_.clear(); }
  void add(const PlaceArrays& places, Range range);  // (7.4), (9.10)
  /// Node (i, j) of the grid; per length (7.5), (9.11).
  Pair gradient(int i, int j) const;
  /// Colours of the four cells around the node together.
  double around(int i, int j) const;

 private:
  double cell(int i, int j) const {
    const int column = i + 1, row = j + 1;  // -1 is behind the wall
    return color_[column_[static_cast<std::size_t>(column)] + row_[static_cast<std::size_t>(row)]];
  }

  Locator locator_;
  std::vector<std::size_t> column_, row_;
  RoundSums<double> color_;
};

/// Simple colour (7.2), (7.3): gradients of linear shape functions, summed at nodes.
class ColorNormals {
 public:
  ColorNormals(const BackgroundGrid& shape, const Walls& walls);
  void update(const PlaceArrays& places, Range membrane, std::span<const Range> others, const Tangents& tangents);

 private:
  void add(const PlaceArrays& places, Range range);
  Pair normal(int i, int j) const;

  Locator locator_;
  double least_;
  std::vector<double> sides_x_, sides_y_;  // of a node: 2 on a wall that mirrors, else 1
  RoundSums<Pair> sums_;
};

/// Quadratic colour of cells (7.4), its gradient at nodes (7.5), linear to the points (7.3).
class QuadraticNormals {
 public:
  QuadraticNormals(const BackgroundGrid& shape, const Walls& walls);
  void update(const PlaceArrays& places, Range membrane, std::span<const Range> others, const Tangents& tangents);

 private:
  Locator locator_;
  double least_;
  CellColor color_;
};

/// Cubic colour of nodes (7.6) and the kernel's own gradient (7.7).
class CubicNormals {
 public:
  CubicNormals(const BackgroundGrid& shape, const Walls& walls);
  void update(const PlaceArrays& places, Range membrane, std::span<const Range> others, const Tangents& tangents);

 private:
  void add(const PlaceArrays& places, Range range);
  Pair gradient(const CellPlace& at) const;

  Locator locator_;
  double least_;
  std::vector<std::size_t> column_, row_;
  std::vector<double> sides_x_, sides_y_;  // of a place in column_ or row_: 2 on a wall that mirrors, else 1
  RoundSums<double> color_;
};

}  // namespace tether::mpm
