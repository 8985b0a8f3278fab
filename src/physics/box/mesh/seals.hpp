// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "physics/box/mesh/flow_mesh.hpp"

namespace tether::coupled {

/// Returns a mesh without the films that would join parts of the fluid which have nothing else in common: a body that
/// touches walls on both sides parts the fluid, and so does one that closes an opening. Films are cells lower than
/// `height` [length].
FlowMesh without_seals(FlowMesh mesh, double height);

}  // namespace tether::coupled
