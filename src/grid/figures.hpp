// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <variant>
#include <vector>

#include "base/vec.hpp"
#include "grid/mesh.hpp"
#include "grid/polygon.hpp"

namespace tether {

// Figures that decks describe, for parts of a box. In the plane z is 0.

/// An ellipse, in space an ellipsoid, along the axes.
struct Ellipsoid {
  Vec<3> middle{}, half{};  ///< half: its half axes; a half axis of 0 is left out [length]
};

/// A polygon in x and y, in space a prism along all of z.
struct Prism {
  Polygon base;
};

/// All that lies on one side of a line, in space of a plane.
struct HalfSpace {
  Vec<3> place{};   ///< of it [length]
  Vec<3> normal{};  ///< of length 1, away from what it has
};

using Figure = std::variant<Box<3>, Ellipsoid, Prism, HalfSpace>;

/// Returns whether a figure has a place.
bool contains(const Figure& figure, const Vec<3>& x);

/// Returns whether two figures in space have a place in common. No half axis may be 0.
bool meet(const Ellipsoid& ellipsoid, const Box<3>& box);
bool meet(const Ellipsoid& one, const Ellipsoid& other);

/// A figure's surface as edges or triangles, turned as a solid's (grid/solid_surface.hpp).
struct FigureSurface {
  std::vector<double> x;  ///< places of its nodes, dim numbers a node [length]
  Sides sides;            ///< dim nodes of each facet
};

/// Returns it within a box at least. What has no end ends beyond the box; what is curved is made of facets that differ
/// from it by about a thousandth of `cell`, and has the figure's own volume.
FigureSurface surface_of(const Figure& figure, int dim, const Box<3>& box, double cell);

}  // namespace tether
