// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"
#include "model/scene.hpp"
#include "model/solids.hpp"

namespace tether {

/// The rigid body that $rigid describes, with the velocity that its regions share. Mistakes are reported at their
/// places: directors in one plane, places with a component missing, forces without a place, regions that part.
std::shared_ptr<const Rigid> rigid_of(const Deck& deck, Diagnostics& diagnostics);

/// Reports what the deck asks for and a rigid body cannot have: no mesh or a plane one, supports, damping, a static
/// problem, steps by another rule; warns of what has no effect.
void check_rigid(const Deck& deck, Diagnostics& diagnostics);

/// Reports a plane mesh, and a reference point or a pin so far from the mesh that the body's inertia would be lost
/// beside that of its arm.
void check_rigid_places(const Deck& deck, const Rigid& rigid, const Mesh& mesh, Diagnostics& diagnostics);

/// Reports nodes that stand at an edge of the grid whose wall would hold them.
void check_rigid_walls(const Deck& deck, const Scene& scene, const Mesh& mesh, Diagnostics& diagnostics);

}  // namespace tether
