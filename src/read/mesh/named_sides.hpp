// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"
#include "grid/mesh.hpp"

namespace tether {

/// The sides of a mesh that variable(k) of a group names, or null where the mesh has none of that name, which is told.
const Sides* named_sides(const Deck& deck, const std::string& group, const std::string& variable, int k,
                         const Mesh& mesh, Diagnostics& diagnostics);

/// Tells of elements k of the group's variables `others`, "load 3" where `what` is "load", that act on nothing: on(k)
/// is not given.
void check_all_act(const Deck& deck, const std::string& group, const std::string& what, const std::string& on,
                   const std::vector<std::string>& others, Diagnostics& diagnostics);

}  // namespace tether
