// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "grid/contact/pairs.hpp"
#include "grid/contact/surface.hpp"
#include "grid/contact/surface_plane.hpp"

namespace tether {

/// How far surfaces are apart, where they are nearest to each other.
struct Apart {
  double away = 0;            ///< [length]; infinite where none is as near as was asked
  int side = -1, other = -1;  ///< of the mesh; -1 of an obstacle or a plane
  Vec<3> place{};             ///< a node of the first [length]
};

/// Finds where surfaces, or nodes and planes, are nearest to each other with the nodes at q, of those nearer than
/// `least` [length].
Apart nearest_surfaces(const ContactSurface& surface, WhoMeets who, std::span<const SurfacePlane> planes,
                       std::span<const double> q, double least, Team& team);

}  // namespace tether
