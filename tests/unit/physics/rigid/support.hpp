// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

#include "physics/rigid/step.hpp"

// Bodies for the tests of rigid bodies, and Euler's equations integrated closely to compare with.

namespace tether::fem::rigid {

using Eigen::Matrix3d;
using Eigen::Vector3d;

using Step = RigidReport (*)(const RigidBody&, const RigidForces&, double, RigidState&, const RigidNewtonRule&);

/// Numbers of both signs in -1 .. 1 without any order, the same ones in each run.
template <class Matrix>
Matrix any_numbers() {
  return Matrix::NullaryExpr(
      [](Eigen::Index i, Eigen::Index j) { return std::sin(1.0 + 2.3 * i * (1 + j) + 5.1 * j); });
}

/// A box, axes along x, y, z, as the Gauss points of its trilinear elements (nx x ny x nz of 2 x 2 x 2 points).
struct Box {
  Vector3d low{-0.5, -0.3, -0.1}, high{0.5, 0.3, 0.1};
  double density = 2;
  int elements[3] = {2, 1, 1};

  Vector3d size() const { return high - low; }
  Vector3d centre() const { return (low + high) / 2; }
  double mass() const { return density * size().prod(); }
  /// Principal moments of inertia about the centre, M (b^2 + c^2)/12.
  Vector3d principal() const {
    const Vector3d a = size().cwiseAbs2();
    return mass() / 12 * (a.sum() * Vector3d::Ones() - a);
  }
};

struct MassPoints {
  std::vector<double> positions, masses;
};

inline MassPoints gauss_points(const Box& box) {
  MassPoints points;
  std::array<std::vector<double>, 3> along;
  for (int i = 0; i < 3; ++i) {
    const double h = box.size()[i] / box.elements[i];
    for (int e = 0; e < box.elements[i]; ++e) {
      for (const double xi : {-1 / std::sqrt(3), 1 / std::sqrt(3)})
        along[static_cast<std::size_t>(i)].push_back(box.low[i] + h * (e + 0.5 + 0.5 * xi));
    }
  }
  const double mass = box.mass() / static_cast<double>(along[0].size() * along[1].size() * along[2].size());
  for (const double z : along[2]) {
    for (const double y : along[1]) {
      for (const double x : along[0]) {
        points.positions.insert(points.positions.end(), {x, y, z});
        points.masses.push_back(mass);
      }
    }
  }
  return points;
}

inline RigidFrame orthonormal(const Vector3d& point = Vector3d::Zero()) { return {point, Matrix3d::Identity()}; }

/// Directors of several lengths and angles, and a reference point outside of the box.
inline RigidFrame skew() {
  RigidFrame frame{{0.7, -0.4, 0.3}, {}};
  frame.directors << 1.2, 0.3, -0.2, 0.4, 0.7, 0.5, -0.1, 0.2, 1.6;
  return frame;
}

inline RigidInertia inertia_of(const Box& box, const RigidFrame& frame) {
  const MassPoints points = gauss_points(box);
  return rigid_inertia(frame, points.positions, points.masses);
}
inline RigidBody body_of(const Box& box, const RigidFrame& frame) { return rigid_body(frame, inertia_of(box, frame)); }
inline RigidBody body_of(const Box& box, const RigidFrame& frame, const Vector3d& pin) {
  return rigid_body(frame, inertia_of(box, frame), pin);
}

/// The body's state when its centre of mass moves with `velocity`.
inline RigidState start(const RigidBody& body, const Vector3d& velocity, const Vector3d& omega) {
  const Vector3d arm = body.frame.point - body.inertia.centre(body.frame.columns());
  return rigid_start(body, velocity + omega.cross(arm), omega);
}

/// F = d D^-1, the rotation from the reference configuration.
inline Matrix3d rotation(const RigidBody& body, const RigidState& state) {
  return state.q.rightCols<3>() * body.frame.directors.inverse();
}

/// Place of a body point given in the reference configuration.
inline Vector3d place(const RigidBody& body, const RigidState& state, const Vector3d& reference) {
  return state.q.col(0) + state.q.rightCols<3>() * body.frame.convective(reference);
}

/// A rigid body turning about a point with fixed place: Euler's equations I w' + w x I w = R^T m and Q' = Q (0, w)/2,
/// in the body's axes, by the fifth-order formula of Dormand and Prince (J. Comp. Appl. Math. 6, 1980) in short steps.
struct Turning {
  Matrix3d inertia;                                             ///< about the point
  std::function<Vector3d(double t, const Matrix3d& R)> torque;  ///< in space
  Eigen::Matrix<double, 7, 1> state =
      Eigen::Matrix<double, 7, 1>::Zero();  ///< quaternion x, y, z, w; omega in the body

  Turning(const Matrix3d& about_point, const Vector3d& omega) : inertia(about_point) { state << 0, 0, 0, 1, omega; }

  Matrix3d rotation() const { return quaternion(state).normalized().toRotationMatrix(); }
  Vector3d omega() const { return rotation() * state.tail<3>(); }  ///< in space

  void run(double time, int steps) {
    for (int n = 0; n < steps; ++n) step(n * time / steps, time / steps);
  }

 private:
  using State = Eigen::Matrix<double, 7, 1>;
  static Eigen::Quaterniond quaternion(const State& y) { return {y[3], y[0], y[1], y[2]}; }
  State rate(double t, const State& y) const {
    const Vector3d w = y.tail<3>();
    const Vector3d m = torque ? quaternion(y).conjugate() * torque(t, quaternion(y).normalized().toRotationMatrix())
                              : Vector3d::Zero();
    State dy;
    dy << 0.5 * (quaternion(y) * Eigen::Quaterniond(0, w[0], w[1], w[2])).coeffs(),
        inertia.inverse() * (m - w.cross(inertia * w));
    return dy;
  }
  void step(double t, double h) {
    static constexpr double a[5][5] = {{1. / 5},
                                       {3. / 40, 9. / 40},
                                       {44. / 45, -56. / 15, 32. / 9},
                                       {19372. / 6561, -25360. / 2187, 64448. / 6561, -212. / 729},
                                       {9017. / 3168, -355. / 33, 46732. / 5247, 49. / 176, -5103. / 18656}};
    static constexpr double b[6] = {35. / 384, 0, 500. / 1113, 125. / 192, -2187. / 6784, 11. / 84};
    static constexpr double c[6] = {0, 1. / 5, 3. / 10, 4. / 5, 8. / 9, 1};
    State k[6];
    for (int i = 0; i < 6; ++i) {
      State y = state;
      for (int j = 0; j < i; ++j) y += h * a[i - 1][j] * k[j];
      k[i] = rate(t + c[i] * h, y);
    }
    for (int i = 0; i < 6; ++i) state += h * b[i] * k[i];
  }
};

/// Logarithm to base 2 of the ratio of errors of a step and of its half.
inline double order(double coarse, double fine) { return std::log2(coarse / fine); }

}  // namespace tether::fem::rigid
