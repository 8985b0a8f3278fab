// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "physics/rigid/state.hpp"

namespace tether::fem {

/// The step (35) as it stands: gain z of the 12 velocities, six multipliers and, with Pins = 3, three more for the
/// fixed point. All in the units of RigidMiddle, multipliers times (dt/2)^2.
template <int Pins>
class RigidConstrained {
 public:
  static constexpr int size = 18 + Pins;
  using Vector = Eigen::Matrix<double, size, 1>;
  using Matrix = Eigen::Matrix<double, size, size>;

  explicit RigidConstrained(const RigidMiddle& middle) : middle_(middle) {}

  Vector start() const { return Vector::Zero(); }     ///< the body goes on as it did; no multipliers
  double residual(const Vector& x, Vector& r) const;  ///< returns its relative size
  Matrix tangent(const Vector& x) const;              ///< d residual / d x
  Vector correction(const Vector& x, const Vector& r) const;
  RigidIncrements increments(const Vector& x) const;
  Eigen::Vector3d half_turn(const Vector& x) const;  ///< (dt/2) omega_{n+1/2}

 private:
  void momentum_tangent(const Vector& x, Matrix& J) const;
  RigidColumns gain(const Vector& x) const { return x.template head<12>().reshaped(3, 4); }
  RigidColumns half_step(const Vector& x) const { return middle_.drift + gain(x); }
  const RigidMiddle& middle_;
};

}  // namespace tether::fem
