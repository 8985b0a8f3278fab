// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>

#include "grid/crossings.hpp"
#include "physics/box/outside.hpp"

namespace tether::coupled {

/// Of each axis, where the surface passes between the middles of faces: these are the middles of a grid's cells that
/// lies half a cell lower, and have the same numbers.
using SurfaceNearFaces = std::array<Crossings, 3>;
SurfaceNearFaces surface_near_faces(const SolidSurface& surface, std::span<const double> q, const StaggeredGrid& grid);

/// The surface that is next to a face's middle on one side.
struct SurfaceNear {
  const Crossing* crossing = nullptr;
  double cells = 0;  ///< how far it is [cells]
};

/// The volume of the box about a face, from one cell's middle to the next; half a cell's at the sides.
double whole_box(const StaggeredGrid& grid, int axis, std::size_t face);

/// The surface next to the faces across one axis.
class NearSurface {
 public:
  /// Both must outlive it.
  NearSurface(const StaggeredGrid& grid, int axis, const Crossings& crossings)
      : grid_(grid), axis_(axis), crossings_(crossings) {}

  /// Returns whether a face's middle lies in a solid.
  bool holds(std::size_t face) const { return crossings_.inside[face] != 0; }
  /// Between a face's middle and the next one along axis b, or the box's side where there is none.
  std::optional<SurfaceNear> between(const std::array<int, 3>& face, std::size_t b, bool up) const;
  /// The surface that closes the next face along axis b, where none is between: it lies between that face's middle and
  /// one of the two middles of cells next to it.
  std::optional<SurfaceNear> closing(const std::array<int, 3>& face, std::size_t b, bool up) const;
  /// The nearer one of those before and after a face's middle along axis b.
  std::optional<SurfaceNear> along(const std::array<int, 3>& face, std::size_t b) const;
  /// The nearest one of those on lines along all axes.
  std::optional<SurfaceNear> nearest(const std::array<int, 3>& face) const;

 private:
  const Crossing* first(std::array<int, 3> face, std::size_t b, bool up) const;

  const StaggeredGrid& grid_;
  int axis_;
  const Crossings& crossings_;
};

}  // namespace tether::coupled
