// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace tether::fem {

struct RigidNewtonRule {
  /// Largest residual, over the sum of its terms' norms, with which a step may end. Iterations go on below it until
  /// rounding stops them: a residual left over in each step is what energy would drift by.
  double tolerance = 1e-12;
  int most_iterations = 20;  ///< up to RigidReport::most
};

/// How a step ended. Where `converged` is false the state is as it was before, and a shorter step may succeed.
struct RigidReport {
  static constexpr int most = 31;
  bool converged = false;
  int iterations = 0;                               ///< corrections made
  std::array<double, most + 1> residuals{};         ///< relative, before each correction and after the last
  Eigen::Vector3d omega = Eigen::Vector3d::Zero();  ///< angular velocity of the step: v_i = omega x d_i at n+1/2
  double work = 0;                                  ///< of all loads in the step, dt v_{n+1/2} . F_{n+1/2} [energy]

  double residual() const { return residuals[static_cast<std::size_t>(iterations)]; }
};

/// |part| over |terms|; 0 where there are none.
inline double rigid_ratio(double part, double terms) { return part == 0 ? 0 : part / terms; }

/// Newton's method until rounding stops it. The system gives residual(x, r), which fills r and returns its relative
/// size, and correction(x, r) = tangent^-1 r.
template <class System>
void rigid_newton(const System& system, typename System::Vector& x, const RigidNewtonRule& rule, RigidReport& report) {
  // The terms are counted by bounds of their norms, beside which rounding is smaller than epsilon.
  constexpr double rounding = 0.25 * std::numeric_limits<double>::epsilon();
  const int last = std::min(rule.most_iterations, RigidReport::most);
  typename System::Vector r;
  double before = std::numeric_limits<double>::infinity();
  for (report.iterations = 0;; ++report.iterations) {
    const double now = system.residual(x, r);
    report.residuals[static_cast<std::size_t>(report.iterations)] = now;
    report.converged = now <= rounding || (now <= rule.tolerance && now > before / 2);
    if (report.converged || report.iterations == last || !std::isfinite(now)) return;
    before = now;
    x -= system.correction(x, r);
  }
}

}  // namespace tether::fem
