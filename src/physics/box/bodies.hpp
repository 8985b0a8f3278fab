// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "grid/solid_surface.hpp"
#include "model/coupled.hpp"
#include "model/scene.hpp"
#include "physics/box/placer.hpp"

namespace tether::coupled {

/// Returns for each body the side of the box that all of its surface is beyond, or -1.
std::vector<int> sides_left_by(const SolidSurface& surface, std::span<const double> q, const StaggeredGrid& grid);

/// Says that a body, counted from 0, has left by a side.
std::string leaving_text(const Coupled& scene, const SolidSurface& surface, std::span<const double> q, int body,
                         int side);

/// Where bodies, or gaps between them, are thinner than a cell: parts of cells say nothing there.
struct ThinBodies {
  std::size_t cells = 0;     ///< that count as wholly fluid or solid for it
  std::size_t of_cells = 0;  ///< cells that the bodies' surface goes through
  int body = -1;             ///< whose surface goes through the first of them, from 0
  Vec<3> place{};            ///< of that one's middle [length]
};
ThinBodies thin_bodies(const Placement& placed, const SolidSurface& surface);

/// Says what a user is to know of them; empty where there are none.
std::string thin_text(const ThinBodies& thin, int dim);

/// Says the same of a scene at its start; empty where its mode takes no parts of cells.
std::string thin_text(const Scene& scene);

}  // namespace tether::coupled
