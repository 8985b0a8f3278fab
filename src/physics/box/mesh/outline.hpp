// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/vec.hpp"
#include "grid/solid_surface.hpp"
#include "model/coupled.hpp"
#include "physics/box/mesh/flow_mesh.hpp"

namespace tether::coupled {

/// What bounds a fluid in the plane: segments from one place to another, the fluid to the right of each.
struct PlaneOutline {
  struct Segment {
    std::array<std::size_t, 2> ends;  ///< among the places
    Boundary boundary;
  };
  std::vector<Vec<3>> places;
  std::vector<Segment> segments;
};

/// The sides of the box, in parts no longer than `size` that end where jets and openings do, obstacles, and the solids'
/// surface with its nodes at q as far as it lies in the box. Places that solids share with a wall, and those beyond it,
/// lie `away` from it: there a film of fluid is left [length].
PlaneOutline plane_outline(const Coupled& scene, const SolidSurface& surface, std::span<const double> q, double size,
                           double away);

}  // namespace tether::coupled
