// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tether {

/// The step from `time`: dt, or what is left to tmax. A last step a 1e-9 longer than dt is taken whole: rounding in the
/// sum of steps must not leave a sliver before tmax. [time]
inline double step_before_end(double dt, double time, double tmax) {
  constexpr double stretch = 1 + 1e-9;
  const double left = tmax - time;
  return left <= dt * stretch ? left : dt;
}

/// sum += term, with what rounding takes from it kept in `lost` (Kahan's sum): 1e5 equal steps must end where their
/// product says.
inline void add_compensated(double& sum, double& lost, double term) {
  const double owed = term - lost, next = sum + owed;
  lost = (next - sum) - owed;
  sum = next;
}

}  // namespace tether
