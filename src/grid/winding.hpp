// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "grid/solid_surface.hpp"

namespace tether {

/// How often the surfaces of all bodies but one go round x: 1 within a solid, more where several overlap, 0 outside.
double turns_about(const SolidSurface& surface, std::span<const double> q, const Vector& x, int but_part);

}  // namespace tether
