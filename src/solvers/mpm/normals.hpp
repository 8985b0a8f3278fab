// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <variant>

#include "model/method.hpp"
#include "solvers/mpm/normals_cells.hpp"
#include "solvers/mpm/normals_grid.hpp"
#include "solvers/mpm/normals_membrane.hpp"

namespace tether::mpm {

/// Tangents of a membrane's points from where the points stand, without their connectivity (chapter 7). Keeps work
/// space only: what a step leaves behind is its tangents.
class MembraneNormals {
 public:
  /// The method's rule, which is not connectivity. Walls stand at the edges of `shape`, and no point beyond them;
  /// `most_points` is the size of the largest membrane.
  MembraneNormals(const BackgroundGrid& shape, const Walls& walls, const Method& method, std::size_t most_points);

  /// Turns the tangents of the membrane's points to where they stand now; each keeps the sense it had. `others` are
  /// the points that lend the color, quadratic and cubic rules their colour; the mass matrix asks the membrane alone.
  void update(const PlaceArrays& places, Range membrane, std::span<const Range> others, const Tangents& tangents);

 private:
  std::variant<ColorNormals, QuadraticNormals, CubicNormals, CellMatrixNormals<LinearColor>,
               CellMatrixNormals<QuadraticColor>, MembraneMatrixNormals<LinearColor>,
               MembraneMatrixNormals<QuadraticColor>>
      rule_;
};

}  // namespace tether::mpm
