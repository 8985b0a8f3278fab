// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>

#include "physics/box/step.hpp"

namespace tether::coupled {

/// The largest x M_a x / x R x of all motions x of the solids' nodes at q, which supports let go: M_a = B^T L^-1 B,
/// with L of a step of 1, is their added mass in the box's cells; R = M + C h/2, by the trapezoidal rule M, resists it.
/// When fluid and solids are solved one after the other, fluid at rest, velocities z^n x have by the paper's step
///     z (z - 1)^2 M x + z^2 (z - 1) C x h + z^2 (z + 1) K x h^2/2 + (z - 1)^2 M_a x = 0.
/// Multiplied by x this is a cubic with positive numbers m, c, k, m_a, whose roots are all within the unit circle where
/// m_a < m + c h/2 (Jury's conditions): below 1 no motion grows. Above 1 the matrix has a positive eigenvalue at z = -1
/// and none for z far below, so that one motion has a root z < -1. Stiffness has no part in the limit, nor has the step
/// without damping. None where a closed region of the fluid makes M_a infinite. `density` is the fluid's.
std::optional<double> added_mass_ratio(const CoupledStep& step, std::span<const double> q, double density, double h);

/// Returns the same for a scene's bodies where they are at the start, in a step of h; none without bodies, or where its
/// systems are too large for factors.
std::optional<double> added_mass_ratio(const Scene& scene, double h);

/// Whether splitting holds, and why, as the end of a sentence.
struct SplittingOutlook {
  bool holds = false;
  std::optional<double> ratio;  ///< where it is known, by theory; else by the plan's estimate
  std::string why;
};

/// None without bodies.
std::optional<SplittingOutlook> splitting_outlook(const Scene& scene, double h);

/// That in a line, or nothing.
std::string splitting_text(const Plan& plan);

}  // namespace tether::coupled
