// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vec.hpp"
#include "grid/contact/carried_places.hpp"
#include "grid/mesh.hpp"

namespace tether {

/// An edge in the plane, a triangle in space, that places are kept away from. Corners are carried places.
struct ContactFacet {
  std::array<int, 3> corners{-1, -1, -1};
  int side = -1;  ///< of the mesh; -1 of an obstacle
};

/// Where facets meet: what the distances to several of them count twice. A corner (one place) or in space an edge
/// (two).
struct ContactJoint {
  std::array<int, 2> ends{-1, -1};
  std::vector<int> facets;  ///< that meet there
  double weight = -1;       ///< of its distance in the sum of all distances: facets less edges and corners
};

/// A place of a side whose distance from other surfaces counts, with its part of the side's area.
struct ContactPoint {
  int place = -1, side = -1;
  double area = 0;  ///< of the shape at the start [area, in the plane per unit depth: length]
};

/// The surface of bodies and obstacles, as contact sees it, in two ways that hang together without gaps.
///
/// Pressing: points of quadrature on the sides, and facets between their corners and middles. A facet's distance is
/// linear in its corners, a side's shape of order 2 is not: the middle of an edge is taken at 4/3 m - (a + b)/6 of the
/// edge's nodes, where the facets enclose the same area as the side, so that pressures which are constant or linear
/// push at the nodes as on the side itself. A side of four corners is parted by its middle, so that none of its
/// diagonals is preferred.
///
/// Guarding: nodes, and facets and edges between them, which nothing passes.
struct ContactSurface {
  CarriedPlaces places;
  std::vector<ContactPoint> points;
  std::vector<ContactFacet> facets;
  std::vector<ContactJoint> joints;
  std::vector<ContactPoint> guards;  ///< nodes, and corners of obstacles
  std::vector<ContactFacet> guard_facets;
  std::vector<ContactFacet> guard_edges;  ///< in space; two corners each, `side` one that it belongs to
  std::vector<double> edge_lengths;       ///< at the start [length]
  std::vector<std::vector<int>> side_nodes;
  std::vector<int> side_part, side_region;  ///< connected body, and region of the element
  double shortest = 0;                      ///< edge of a side between its corners, at the start [length]

  int dim() const { return places.dim; }
};

/// Makes the surface of a mesh and of obstacles; `nodes`: those of the sides that take part, ascending, or all where it
/// is empty; `parts`: how many of them with points of their own a line of a side is cut into.
ContactSurface contact_surface(const Mesh& mesh, std::span<const int> nodes, const std::vector<Box<3>>& obstacles,
                               int parts = 1);

}  // namespace tether
