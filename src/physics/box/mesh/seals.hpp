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

/// Returns a mesh without the regions that are marked.
FlowMesh without_regions(FlowMesh mesh, std::span<const std::uint8_t> marked);

}  // namespace tether::coupled
