// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/box/mesh/flow_mesh.hpp"

namespace tether::coupled {

/// Returns a mesh without the films that would join parts of the fluid which have nothing else in common: a body that
/// touches walls on both sides parts the fluid, and so does one that closes an opening. Films are cells lower than
/// `height` [length]; with them go parts of the fluid no larger than `pocket` [volume], as between bodies that touch.
FlowMesh without_seals(FlowMesh mesh, double height, double pocket);

/// Returns a mesh without the closed parts of the fluid that are no larger than `pocket` [volume], where a sheet of the
/// solids has a larger part on it, too: bodies that overlap shut them in, and nothing could leave them. `closed` has a
/// number for each part.
FlowMesh without_pockets(FlowMesh mesh, const std::vector<std::uint8_t>& closed, std::span<const int> sheets,
                         double pocket);

}  // namespace tether::coupled
