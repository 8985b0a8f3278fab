// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laws/tensors.hpp"
#include "solvers/mpm/normals_grid.hpp"

namespace tether::mpm {

/// Grid normals of a body for contact (A.1.4). Every point of the body has the colour 1; what mirrors behind a wall
/// belongs to the body, so that its normals on the wall lie along it.
class BodyNormals {
 public:
  BodyNormals(const BackgroundGrid& shape, const Walls& walls);

  /// Takes up the colour of a body in place of the one before (9.10).
  void take(const PlaceArrays& places, Range body);
  /// Unit normal at a node, out of the body (9.11). Zero where its colour has no slope: inside, away from it, and on a
  /// membrane's own line.
  Vec2 outward(int node) const;

 private:
  int nx_;
  double least_;
  CellColor color_;
};

}  // namespace tether::mpm
