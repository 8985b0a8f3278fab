// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"
#include "model/path.hpp"

namespace tether {

/// The path that `wanted` names ("": the deck's own: coupled with $coupled, fem with $fem, $mesh, $rigid or $flow, else
/// mpm). A deck that describes a mesh has no points for the mpm path, and $coupled belongs to one path: asking for
/// another is an error.
Path path_of(const Deck& deck, const std::string& wanted, Diagnostics& diagnostics);

}  // namespace tether
