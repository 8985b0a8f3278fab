// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "model/scene.hpp"

namespace tether {

// What a scene lacks for an exact solution to be its own, as the user is told after "needs"; empty where it lacks
// nothing. One function a solution; reference_of() chooses.

std::string lacks_for_riemann(const Scene& scene);
std::string lacks_for_radial_gas(const Scene& scene);
std::string lacks_for_thin_ring(const Scene& scene);
std::string lacks_for_spring(const Scene& scene);
std::string lacks_for_string(const Scene& scene);
std::string lacks_for_pendulum(const Scene& scene);
std::string lacks_for_piston(const Scene& scene);

/// Bodies of a law.
template <class Law>
std::size_t count_bodies(const Scene& scene) {
  std::size_t count = 0;
  for (const Body& body : scene.bodies) count += std::holds_alternative<Law>(body.material) ? 1 : 0;
  return count;
}

/// Whether no point of a body moves at the start.
inline bool begins_at_rest(const Scene& scene, const Body& body) {
  for (std::size_t p = body.first; p < body.first + body.count; ++p) {
    if (scene.points.vx[p] != 0 || scene.points.vy[p] != 0) return false;
  }
  return true;
}

}  // namespace tether
