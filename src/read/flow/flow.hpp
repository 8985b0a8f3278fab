// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"
#include "model/flow.hpp"
#include "model/scene.hpp"
#include "model/solids.hpp"

namespace tether {

/// Adds the fluid that $reg, $mesh, $fem and $flow describe, and the bodies immersed in it. Mistakes are reported at
/// their places.
void add_flow(const Deck& deck, Scene& scene, Diagnostics& diagnostics);

/// The vector whose components are the texts of $flow with these names and the number k; `of` is what it belongs to.
FlowVector flow_vector_of(const Deck& deck, const std::array<TextVariable, 2>& names, int k, const std::string& of,
                          Diagnostics& diagnostics);

/// All of the boundary, by boundary_on; of a periodic pair both sides, one after the other.
std::vector<FlowSide> flow_sides_of(const Deck& deck, const Mesh& mesh, Diagnostics& diagnostics);
/// Lists what forces are recorded of: sides of the fluid's mesh, bodies and sides of these; `solids` is null where
/// there are none.
std::vector<ForceSide> force_sides_of(const Deck& deck, const Mesh& mesh, const Solids* solids,
                                      Diagnostics& diagnostics);
/// Flow::twin of periodic pairs among these sides.
std::vector<int> twins_of(const Deck& deck, const Mesh& mesh, const std::vector<FlowSide>& sides,
                          Diagnostics& diagnostics);

/// Places at which the flow is recorded, differences between them, and tracers.
void add_probes(const Deck& deck, Flow& flow, Diagnostics& diagnostics);

}  // namespace tether
