// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "physics/box/liquid/particles.hpp"
#include "physics/box/liquid/surface.hpp"

namespace tether::liquid {

/// What a liquid is as a whole.
struct LiquidSums {
  std::size_t particles = 0;
  double volume = 0;                ///< of the particles
  Vec<3> middle{}, velocity{};      ///< means of these
  double kinetic = 0, gravity = 0;  ///< of these, gravity from the origin [energy]
  double enclosed = 0;              ///< volume that the surface, walls and bodies enclose
  double area = 0;                  ///< of the surface
};

LiquidSums sums_of(const Particles& particles, int dim, double density, const Vec<3>& gravity);

/// Adds what the surface encloses, and its area: the distance is taken as linear in simplices between the cells'
/// middles, or between these and walls of the box.
void add_surface(const Surface& surface, LiquidSums& sums);

}  // namespace tether::liquid
