// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "grid/crossings.hpp"
#include "physics/box/outside.hpp"

namespace tether::coupled {

/// A viscous fluid sticks to bodies. The middle of a face and the nearest surface of a body on a line along an axis
/// exchange momentum as if the velocity were linear between them: a force mu A (v - u) / distance, u being the
/// surface's velocity where the line meets it. (F. Gibou et al., J. Comput. Phys. 176 (2002) 205-227, hold a value at
/// such a place alike: of order 2 in the velocity.)

/// Of each axis, where the surface passes between the middles of faces: these are the middles of a grid's cells that
/// lies half a cell lower, and have the same numbers.
using SurfaceBesideFaces = std::array<Crossings, 3>;
SurfaceBesideFaces surface_beside_faces(const SolidSurface& surface, std::span<const double> q,
                                        const StaggeredGrid& grid);

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

  /// Between a face's middle and the next one along axis b, or the box's side where there is none.
  std::optional<SurfaceNear> between(const std::array<int, 3>& face, std::size_t b, bool up) const;
  /// The surface that closes the next face along axis b, where none is between: it lies between that face's middle and
  /// one of the two middles of cells beside it.
  std::optional<SurfaceNear> closing(const std::array<int, 3>& face, std::size_t b, bool up) const;

 private:
  const Crossing* first(std::array<int, 3> face, std::size_t b, bool up) const;

  const StaggeredGrid& grid_;
  int axis_;
  const Crossings& crossings_;
};

/// The bodies' nodes while viscosity acts: the fluid's momentum goes to them, at once and in the same steps, so that
/// bodies of any mass are dragged along and no further. All have dim numbers a node.
struct StickingBodies {
  const SolidSurface& surface;
  const SurfaceBesideFaces& beside;
  std::vector<double> mobility;      ///< 1 / mass of each node; 0 where its velocity is held [1/mass]
  std::vector<double> u;             ///< velocities, which the exchange changes [velocity]
  std::span<const double> driven;    ///< by all but the fluid's friction, in the step before [acceleration]
  double density = 0;                ///< of the fluid [mass/volume]
  std::vector<double> impulse = {};  ///< result: what the fluid gave the nodes [momentum]
};

/// The exchange between the faces across one axis and the surface next to them.
class Drag {
 public:
  Drag(const StaggeredGrid& grid, int axis) : grid_(grid), axis_(at(axis)) {}

  /// Joins a face to the surface near it on one side along axis b; faces come in ascending order and move this `volume`
  /// of fluid. A face whose middle is `within` a body goes along with it.
  void join(std::size_t face, double volume, std::size_t b, const SurfaceNear& near, bool within);
  /// Lets the drag act for a time h, nu [area/time]: implicit for each face with all that is beside it, whatever the
  /// distances and masses.
  void act(double nu, double h, StickingBodies& bodies, std::vector<double>& v) const;

 private:
  struct Link {
    int side;
    Vec<3> share;
    double per_area;  ///< 1 / (d distance), d being a cell's side along the line, over the face's part [1/area]
  };
  struct Star {  // a face with its links, the last of which is before the next one's first
    std::size_t face, first;
    double volume;  ///< of the fluid that it moves
  };

  void act_on(const Star& star, std::size_t end, double by, StickingBodies& bodies, double& v) const;

  const StaggeredGrid& grid_;
  std::size_t axis_;
  std::vector<Link> links_;
  std::vector<Star> stars_;
};

}  // namespace tether::coupled
