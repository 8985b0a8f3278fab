// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/vec.hpp"
#include "model/coupled.hpp"
#include "physics/box/mesh/flow_mesh.hpp"
#include "physics/box/mesh/flow_surface.hpp"

namespace tether::coupled {

/// What bounds a fluid: segments from one place to another in the plane, triangles in space.
struct Outline {
  struct Facet {
    std::array<std::size_t, 3> corners;  ///< dim of them, among the places
    Boundary boundary;
    double size = 0;        ///< of cells at it, at most; 0: its own [length]
    bool has_fluid = true;  ///< what is to the right of a segment, where no body and no obstacle is
  };
  int dim = 2;
  std::vector<Vec<3>> places;
  std::vector<Facet> facets;
  std::vector<std::array<Vec<3>, 2>> around;  ///< in the plane, sides of bodies and obstacles, also beyond the box
  std::vector<Vec<3>> holes;  ///< in space, a place in each part of it that facets enclose and that has no fluid

  /// The length of a segment; the edge of an equilateral triangle as large as a facet.
  double size_of(const Facet& facet) const;
};

/// The sides of the box, in parts that end where jets and openings do, and the surface of bodies (at q) and obstacles
/// as far as it lies in the box, all of it in parts no longer than the sizes of the mesh there. A film of so much is
/// left between bodies, and between them and what else they touch [gap: length].
Outline outline_in_plane(const Coupled& scene, const FlowSurface& surface, std::span<const double> q, double gap);
/// Returns the same in space. There obstacles that are no boxes must not touch anything. Throws RunError where a body
/// reaches through a side of the box.
Outline outline_in_space(const Coupled& scene, const FlowSurface& surface, std::span<const double> q, double gap);

}  // namespace tether::coupled
