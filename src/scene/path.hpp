// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"

namespace tether {

/// The methods that can run a scene: material points, finite elements, fluid and solids on a regular grid.
enum class Path { mpm, fem, coupled };

/// The word for it on the command line and in summary.txt.
const char* path_name(Path path);

/// The path that `wanted` names ("": the deck's own: coupled with $coupled, fem with $fem, $mesh, $rigid or $flow, else
/// mpm). A deck that describes a mesh has no points for the mpm path, and $coupled belongs to one path: asking for
/// another is an error.
Path path_of(const Deck& deck, const std::string& wanted, Diagnostics& diagnostics);

}  // namespace tether
