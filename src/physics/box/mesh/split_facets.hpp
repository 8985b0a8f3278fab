// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "physics/box/mesh/outline.hpp"

namespace tether::coupled {

/// Halves edges of an outline's triangles, from the `first` on, until none is longer than `size` [length]. Triangles
/// that have an edge in common still have all of it in common; each part of one has its boundary
/// and size.
void split_facets(std::size_t first, double size, Outline& outline);

}  // namespace tether::coupled
