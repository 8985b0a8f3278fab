// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "cases/run_deck.hpp"

// What exact solutions the decks of rigid bodies are compared with, and how their histories are read.

namespace tether::cases::rigid {

using Eigen::Matrix3d;
using Eigen::Vector3d;

inline Vector3d last_of(const DeckRun& run, const std::string& name, const std::string& behind = "") {
  return {run.last(name + "x" + behind), run.last(name + "y" + behind), run.last(name + "z" + behind)};
}

/// Directors at the end, d_i in column i.
inline Matrix3d directors(const DeckRun& run) {
  Matrix3d d;
  for (int i = 0; i < 3; ++i) d.col(i) = last_of(run, "director_" + std::to_string(i + 1) + "_");
  return d;
}

/// The box of a deck's region.
struct Box {
  Vector3d low, high;
  double density;
  Vector3d size() const { return high - low; }
  double mass() const { return density * size().prod(); }
};

/// Mass, centre, and moments about the centre of boxes together.
struct Inertia {
  double mass = 0;
  Vector3d centre = Vector3d::Zero();
  Matrix3d moments = Matrix3d::Zero();

  explicit Inertia(const std::vector<Box>& boxes) {
    for (const Box& box : boxes) mass += box.mass(), centre += box.mass() * (box.low + box.high) / 2;
    centre /= mass;
    for (const Box& box : boxes) {
      const Vector3d square = box.size().cwiseAbs2();
      moments += box.mass() / 12 * (square.sum() * Matrix3d::Identity() - Matrix3d(square.asDiagonal()));
      add_offset(box.mass(), (box.low + box.high) / 2 - centre);
    }
  }
  /// Moves the reference point by -arm.
  void add_offset(double m, const Vector3d& arm) {
    moments += m * (arm.squaredNorm() * Matrix3d::Identity() - arm * arm.transpose());
  }
};

/// The attitude R by quaternion x, y, z, w and the angular velocity in the body, of a body that turns about its centre
/// or about a fixed point: I w' + w x I w = R^T m, by Dormand and Prince's formulas to 1e-12 a step.
class Turning {
 public:
  using Torque = std::function<Vector3d(double t, const Matrix3d& R)>;
  Turning(const Matrix3d& moments, const Vector3d& omega, double time, const Torque& torque) {
    namespace ode = boost::numeric::odeint;
    state_ = {0, 0, 0, 1, omega[0], omega[1], omega[2]};
    const auto rate = [&](const State& y, State& dy, double t) {
      const Eigen::Quaterniond Q = quaternion(y);
      const Vector3d w(&y[4]);
      const Eigen::Quaterniond turned = Q * Eigen::Quaterniond(0, w[0], w[1], w[2]);
      const Vector3d moment = Q.normalized().conjugate() * torque(t, Q.normalized().toRotationMatrix());
      const Vector3d dw = moments.inverse() * (moment - w.cross(moments * w));
      dy = {turned.x() / 2, turned.y() / 2, turned.z() / 2, turned.w() / 2, dw[0], dw[1], dw[2]};
    };
    ode::integrate_adaptive(ode::make_controlled<ode::runge_kutta_dopri5<State>>(1e-13, 1e-12), rate, state_, 0.0, time,
                            1e-4);
  }
  Matrix3d rotation() const { return quaternion(state_).normalized().toRotationMatrix(); }
  Vector3d omega() const { return rotation() * Vector3d(&state_[4]); }

 private:
  using State = std::array<double, 7>;
  static Eigen::Quaterniond quaternion(const State& y) { return {y[3], y[0], y[1], y[2]}; }
  State state_{};
};

/// Order of the error of a number that an exact solution knows, over steps of 1, 1/2, 1/4.
inline void expect_second_order(const std::array<double, 3>& error, double least_error) {
  EXPECT_LT(error[2], least_error);
  for (std::size_t k = 0; k < 2; ++k) EXPECT_NEAR(std::log2(error[k] / error[k + 1]), 2, 0.1);
}

}  // namespace tether::cases::rigid
