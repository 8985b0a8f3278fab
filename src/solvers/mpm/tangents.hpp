// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laws/tensors.hpp"
#include "loops/points.hpp"
#include "solvers/mpm/arrays.hpp"

namespace tether::mpm {

/// Unit tangent at a point of a string from its neighbours p - 1 and p + 1 along it, one-sided at its ends (7.1); a
/// closed one has none. A string's slots stay in the order of its file. Zero where the neighbours coincide.
Vec2 tangent_at(const Points& points, Range string, std::size_t p, bool closed = false);

/// eps_1' += dt t . eps' . t with the rates of this step (5.2), (5.4); about an axis the hoop's, too.
void stretch_along_tangents(Points& points, Range string, double dt);

/// New tangents from the present places, and the total strain's component along them (5.3): with eps = eps_1' t (x) t
/// it is eps_1' (t . t_new)^2. That of a string that turns slowly keeps its strain, as it should, to second order of
/// the angle in a step; the jitter of a slack one is damped by it. Where neighbours coincide the tangent of before is
/// kept.
void turn_tangents(Points& points, Range string, bool closed = false);

}  // namespace tether::mpm
