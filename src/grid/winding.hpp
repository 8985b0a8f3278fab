// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "grid/solid_surface.hpp"

namespace tether {

/// Returns how often a surface with its nodes at q goes round a place: 1 inside a body, 0 outside of all.
double winding(const SolidSurface& surface, std::span<const double> q, const Vec<3>& place);

}  // namespace tether
