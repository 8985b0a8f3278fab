// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tether {

// The barrier between two surfaces, by the square s of their distance over the gap's square. A body of small deck units
// and one of large ones meet alike: all is a number. The potential of an area is stiffness gap/2 times barrier(s), so
// that the pressure at the distance x gap is stiffness x (1/x^4 - 3 + 2 x^2).

/// (1 - s)^3 / s below s = 1, and 0 above. It is convex, twice differentiable at 1, and so steep at 0 that no finite
/// energy brings surfaces together; the logarithm of M. Li et al. (ACM Trans. Graph. 39 (2020) 49) is not: of a step's
/// discrete gradient it leaves but a logarithm.
inline double barrier(double s) { return s < 1 ? (1 - s) * (1 - s) * (1 - s) / s : 0; }
/// d barrier / ds
inline double barrier_slope(double s) { return s < 1 ? 3 - 2 * s - 1 / (s * s) : 0; }

/// A slope of the barrier between s0 and s1, and its derivative by s1.
struct BarrierSlope {
  double value = 0, change = 0;
};

/// (barrier(s1) - barrier(s0)) / (s1 - s0), without its rounding: the slope that gives back what it takes.
inline BarrierSlope barrier_quotient(double s0, double s1) {
  if (s0 >= 1 && s1 >= 1) return {};
  if (s0 < 1 && s1 < 1) return {3 - s0 - s1 - 1 / (s0 * s1), 1 / (s0 * s1 * s1) - 1};
  const double way = s1 - s0, value = (barrier(s1) - barrier(s0)) / way;
  return {value, ((s1 < 1 ? barrier_slope(s1) : 0) - value) / way};
}

/// Half of the second derivative of the barrier by the distance over the gap, and its derivative by s = distance^2:
/// times the way across in a step it is what the force of the step's end has beyond the quotient, and takes energy
/// whichever way surfaces go.
inline BarrierSlope barrier_damping(double s) {
  if (s >= 1) return {};
  return {3 / (s * s) + 3 - 6 * s, -6 / (s * s * s) - 6};
}

/// Coulomb's friction over its limit, by the way y that surfaces slide in a step over the way in which it comes up:
/// y (2 - y), 1 from y = 1 on; over y, since a force along the way wants it so.
inline double friction_over_way(double y) { return y < 1 ? 2 - y : 1 / y; }
/// d (friction_over_way(y)) / dy
inline double friction_over_way_slope(double y) { return y < 1 ? -1 : -1 / (y * y); }

}  // namespace tether
