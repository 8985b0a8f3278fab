// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <variant>

#include "base/vec.hpp"
#include "laws/tensors.hpp"
#include "model/method.hpp"
#include "physics/points/normals_cells.hpp"
#include "physics/points/normals_grid.hpp"
#include "physics/points/normals_membrane.hpp"

namespace tether::mpm {

/// Tangents of a membrane's points from where the points stand, without their connectivity (chapter 7). Keeps work
/// space only: what a step leaves is its tangents.
class MembraneNormals {
 public:
  /// The method's rule, which is not connectivity. Walls stand at the edges of `shape`, and no point beyond them;
  /// `most_points` is the size of the largest membrane.
  MembraneNormals(const BackgroundGrid& shape, const Walls& walls, const Method& method, std::size_t most_points);

  /// Turns the tangents of the membrane's points to where they stand now; each keeps the sense it had. `others` are
  /// the points that lend the color, quadratic and cubic rules their colour; the mass matrix asks the membrane alone.
  void update(const PlaceArrays& places, Range membrane, std::span<const Slots> others, const Tangents& tangents);

 private:
  std::variant<ColorNormals, QuadraticNormals, CubicNormals, CellMatrixNormals<LinearColor>,
               CellMatrixNormals<QuadraticColor>, MembraneMatrixNormals<LinearColor>,
               MembraneMatrixNormals<QuadraticColor>>
      rule_;
};

/// Grid normals of a body for contact (A.1.4). Every point of the body has the colour 1; what mirrors behind a wall
/// belongs to the body, so that its normals on the wall lie along it.
class BodyNormals {
 public:
  BodyNormals(const BackgroundGrid& shape, const Walls& walls);

  /// Takes up the colour of a body's points in place of those before (9.10): of those in the slots of the list.
  void take(const PlaceArrays& places, std::span<const std::size_t> points);
  /// Unit normal at a node, out of the body (9.11). Zero where its colour has no slope: inside, away from it, and on a
  /// membrane's own line.
  Vec<2> outward(int node) const;

 private:
  int nx_;
  double least_;
  CellColor color_;
};

}  // namespace tether::mpm
