// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "base/words.hpp"
#include "laws/tensors.hpp"

namespace tether {

/// Stresses or strains of a membrane along its tangent 1' (the meridian) and out of the plane 2' (the hoop).
struct MembraneStress {
  double tangent = 0, hoop = 0;  // [stress]
};

/// A string, spring or membrane of one layer of points. Membrane: stress along the tangent only (5.5)-(5.9). Plane
/// stress: both directions of the surface carry, the thickness none (5.12)-(5.15); in the plane eps_2' = 0, about an
/// axis eps_2' is the hoop strain. With `wrinkle` the one-way law (5.2, Fig. 21): a direction that would be compressed
/// carries nothing and the other one alone, while strains go on accumulating.
struct Membrane {
  enum class Kind { uniaxial, plane_stress };
  double E = 0, nu = 0;  // [stress], number
  bool wrinkle = true;
  Kind kind = Kind::uniaxial;

  /// sigma_1', sigma_2' of the strains eps_1', eps_2'.
  MembraneStress stress(double tangent, double hoop) const {
    if (kind == Kind::uniaxial) return {wrinkle && tangent < 0 ? 0 : E * tangent, 0};  // (5.5)
    const double plane = E / (1 - nu * nu);
    const MembraneStress both{plane * (tangent + nu * hoop), plane * (hoop + nu * tangent)};  // (5.15)
    if (!wrinkle || (both.tangent >= 0 && both.hoop >= 0)) return both;
    // Slack one way, the other is uniaxial; which is also right where both would be compressed.
    if (tangent >= hoop) return {tangent > 0 ? E * tangent : 0, 0};
    return {0, hoop > 0 ? E * hoop : 0};
  }
  /// sigma_1' in the plane, where eps_2' = 0.
  double stress(double tangent) const { return stress(tangent, 0).tangent; }
  /// Energy stored per volume, of which the stresses are the derivatives [stress].
  double energy_density(double tangent, double hoop = 0) const {
    const MembraneStress s = stress(tangent, hoop);
    return 0.5 * (s.tangent * tangent + s.hoop * hoop);
  }
  double sound_speed(double density) const { return std::sqrt(E / density); }

  /// sigma_1' t (x) t in global axes.
  static Stress turned(double tangent_stress, const Vec2& t) {
    return {tangent_stress * t.x * t.x, tangent_stress * t.y * t.y, tangent_stress * t.x * t.y};
  }
};

template <>
inline constexpr std::array<Word<Membrane::Kind>, 2> words<Membrane::Kind>{
    {{Membrane::Kind::uniaxial, "uniaxial"}, {Membrane::Kind::plane_stress, "plane-stress"}}};

}  // namespace tether
