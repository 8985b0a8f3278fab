// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "model/scene.hpp"

namespace tether {

/// How a body can move against the fluid when fluid and solids are solved one after the other.
enum class BodyMotion {
  broadside,  ///< as a whole, across its greatest extent
  swelling    ///< its surface outwards, so that fluid goes out through the nearest opening
};

/// Added mass of one motion of a body against what resists it in a step of h: splitting holds where added < mass +
/// damping. Then the motion that changes its sign every step dies out: stiffness, which such a motion does not load,
/// has no part in it, and by the trapezoidal rule damping has none either. It does slow down what grows otherwise.
struct SplittingEstimate {
  int body = 0;  ///< connected part of the mesh, from 1
  BodyMotion motion = BodyMotion::broadside;
  double added = 0;    ///< M_a; infinite where the fluid has no way out
  double mass = 0;     ///< m, of the nodes that move
  double damping = 0;  ///< by the paper's step c h/2 of Rayleigh's damping, by the trapezoidal rule 0
  double inertia = 0;  ///< m + c h + k h^2/4, by the trapezoidal rule m + c h/2: with M_a what growth goes against
  double resists() const { return mass + damping; }
  bool holds() const { return added < resists(); }
  /// Returns the factor by which the motion grows in a step, to first order in the growth less 1; below 1 it dies out.
  double growth() const { return 1 + 2 * (added - resists()) / (inertia + added); }
};

/// The motion for which the added mass is largest over what resists it, of all bodies of a coupled scene; none without
/// bodies. In the plane masses are per unit depth. Broadside, M_a is that of a flat plate, rho pi/4 L^2 per length
/// across its chord L (J. N. Newman, Marine Hydrodynamics, 1977, table 4.3), all of the body's mass resists, and
/// damping in proportion to the mass. Swelling, the surface S drives fluid through a channel as wide as the box to the
/// nearest open side or void, D away, of cross-section A: M_a = rho S^2 D/A; the masses of the nodes on the surface
/// resist, and damping in proportion to the stiffness lambda + 2 mu of the layer that they stand for. An estimate: its
/// factor is that of the box's shape.
std::optional<SplittingEstimate> splitting_estimate(const Scene& scene);

/// The motion, its masses and by what it grows: the end of a sentence.
std::string estimate_text(const SplittingEstimate& estimate);

}  // namespace tether
