// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"
#include "model/scene.hpp"

namespace tether {

// What a scene lacks for an exact solution to be its own, as the user reads it after "needs"; empty where it lacks
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
  for (const Body& body : scene.bodies) count += std::holds_alternative<Law>(body.material) ? 1U : 0U;
  return count;
}

/// Returns whether no point of a body moves at the start.
inline bool begins_at_rest(const Scene& scene, const Body& body) {
  for (std::size_t p = body.first; p < body.first + body.count; ++p) {
    if (scene.points.vx[p] != 0 || scene.points.vy[p] != 0) return false;
  }
  return true;
}

/// The kind of a name of $reference solution; none for "".
ReferenceKind reference_kind(const std::string& name);

/// The exact solution that $reference names, and whether the scene has what it needs.
ReferenceKind reference_of(const Deck& deck, const Scene& scene, Diagnostics& diagnostics);

/// The part of the tube that $reference window asks for, once the scene has its solution.
std::optional<std::array<double, 2>> reference_window_of(const Deck& deck, const Scene& scene,
                                                         Diagnostics& diagnostics);

}  // namespace tether
