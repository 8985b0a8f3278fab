// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "grid/solid_surface.hpp"
#include "model/coupled.hpp"

namespace tether::coupled {

/// Of each body the side of the box that all of its surface is beyond, or -1.
std::vector<int> sides_left_by(const SolidSurface& surface, std::span<const double> q, const StaggeredGrid& grid);

/// What a run says of a body, counted from 0, that has left by a side.
std::string leaving_text(const Coupled& scene, const SolidSurface& surface, std::span<const double> q, int body,
                         int side);

}  // namespace tether::coupled
