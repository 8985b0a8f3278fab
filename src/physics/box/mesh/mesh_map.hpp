// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "grid/solid_surface.hpp"
#include "physics/box/coupling_map.hpp"
#include "physics/box/mesh/flow_mesh.hpp"

namespace tether::coupled {

/// Which faces of a mesh have pressures of their own.
struct FacePressures {
  std::vector<int> of;               ///< of each face, -1 where it is known: at open sides
  std::vector<std::size_t> face_of;  ///< of each pressure
};

/// Nodes of the solids with their shares in a place on a side.
using NodeShares = std::vector<std::pair<std::size_t, double>>;
/// Those of the place of a facet that is nearest to x, or nearly so, of solids at q.
NodeShares node_shares(const SolidSurface& surface, std::size_t facet, std::span<const double> q, const Vec<3>& x);

/// How much of each sheet of the solids each region of the fluid sees, sheet by sheet [area].
std::vector<double> area_seen(const FlowMesh& mesh, const SolidSurface& surface);

/// Returns what fluxes and forces on solids at q are by the areas of their facets: a face of the fluid at a facet is a
/// part of it, and has the shares of the facet's nodes in the face's middle.
SideEntries fluxes_on_mesh(const FlowMesh& mesh, const FacePressures& pressures, const SolidSurface& surface,
                           std::span<const double> q);

/// Adds the forces of the fluid outside on what is beyond a side of the box, in the plane, to those that a map is
/// given: `high` where it is beyond an upper end along the axis, p(y) the pressure there [stress].
void add_beyond(const SolidSurface& surface, std::span<const double> q, int axis, double end, bool high,
                const std::function<double(double)>& p, SideSums& given);

}  // namespace tether::coupled
