// SPDX-License-Identifier: GPL-3.0-or-later
// The motion of rigid bodies against Euler's equations and the steady top, and that frame and form of the equations do
// not matter.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "unit/physics/rigid/support.hpp"

namespace tether::fem {
namespace {

using namespace rigid;

const Box box{{-0.6, -0.2, 0.1}, {0.4, 0.4, 0.3}, 2, {2, 1, 1}};
const Vector3d pin(0.3, 0.5, -0.2), omega(1, -1.5, 0.7);

Vector3d torque_at(double t) {
  return Vector3d(0.004, -0.01, 0.006) + std::sin(2 * t) * Vector3d(-0.008, 0.004, 0.012);
}

/// Runs to the end time; loads(t) are those at the middle of a step.
template <class Loads>
RigidState run(Step step, const RigidBody& body, RigidState state, double time, int steps, const Loads& loads) {
  const double dt = time / steps;
  for (int n = 0; n < steps; ++n) {
    const RigidReport report = step(body, loads((n + 0.5) * dt), dt, state, {});
    EXPECT_TRUE(report.converged) << "step " << n << " residual " << report.residual();
    if (!report.converged) break;
  }
  return state;
}

/// Errors of the rotation and of the angular velocity for a step and its half and quarter.
struct Errors {
  double rotation[3], omega[3];
};

template <class Loads>
Errors errors(Step step, const RigidBody& body, const RigidState& first, double time, const Turning& exact,
              const Loads& loads) {
  Errors e{};
  for (int k = 0; k < 3; ++k) {
    const RigidState last = run(step, body, first, time, 100 << k, loads);
    e.rotation[k] = (rotation(body, last) - exact.rotation()).norm();
    e.omega[k] = (rigid_angular_velocity(body, last) - exact.omega()).norm() / exact.omega().norm();
  }
  return e;
}

void expect_second_order(const Errors& e, double largest) {
  EXPECT_LT(e.rotation[2], largest);
  EXPECT_LT(e.omega[2], largest);
  for (int k = 0; k < 2; ++k) {
    EXPECT_NEAR(order(e.rotation[k], e.rotation[k + 1]), 2, 0.1);
    EXPECT_NEAR(order(e.omega[k], e.omega[k + 1]), 2, 0.1);
  }
}

TEST(RigidMotion, reference_is_exact_to_twelve_digits) {
  Turning coarse(box.principal().asDiagonal(), omega);
  coarse.torque = [](double t, const Matrix3d&) { return torque_at(t); };
  Turning fine = coarse;
  coarse.run(2, 4000), fine.run(2, 8000);
  EXPECT_LT((coarse.state - fine.state).norm(), 1e-12);
  // About a principal axis alone the solution is known.
  Turning axis(box.principal().asDiagonal(), {0, 0, 3});
  axis.run(2, 4000);
  EXPECT_LT((axis.rotation() - Eigen::AngleAxisd(6, Vector3d::UnitZ()).toRotationMatrix()).norm(), 1e-12);
}

TEST(RigidMotion, under_a_torque_in_time_is_of_second_order) {
  Turning exact(box.principal().asDiagonal(), omega);
  exact.torque = [](double t, const Matrix3d&) { return torque_at(t); };
  exact.run(2, 4000);
  const auto loads = [](double t) { return rigid_torque(torque_at(t)); };
  for (const RigidFrame& frame : {orthonormal(), skew()}) {
    for (const Step step : {rigid_constrained_step, rigid_reduced_step}) {
      const RigidBody body = body_of(box, frame);
      expect_second_order(errors(step, body, start(body, Vector3d::Zero(), omega), 2, exact, loads), 3e-4);
    }
  }
}

TEST(RigidMotion, of_a_heavy_body_hung_at_a_point_is_of_second_order) {
  const Vector3d g(0, 0, -9.81), arm = box.centre() - pin;
  const Matrix3d about_centre = box.principal().asDiagonal();
  const Matrix3d steiner = box.mass() * (arm.squaredNorm() * Matrix3d::Identity() - arm * arm.transpose());
  Turning exact(about_centre + steiner, omega);
  exact.torque = [&](double, const Matrix3d& R) -> Vector3d { return (R * arm).cross(box.mass() * g); };
  exact.run(1, 4000);
  for (const RigidFrame& frame : {orthonormal(), skew()}) {
    const RigidBody body = body_of(box, frame, pin);
    const auto loads = [&](double) { return rigid_gravity(body.inertia, g); };
    for (const Step step : {rigid_constrained_step, rigid_reduced_step})
      expect_second_order(errors(step, body, rigid_start(body, omega), 1, exact, loads), 3e-4);
  }
}

TEST(RigidMotion, thrown_body_falls_on_its_parabola) {
  // The centre of mass is exact at the ends of the steps: the mid-point rule integrates a constant force exactly.
  const Vector3d g(0, 0, -9.81), velocity(1, 2, 7);
  const RigidBody body = body_of(box, skew());
  const auto loads = [&](double) { return rigid_gravity(body.inertia, g); };
  const RigidState last = run(rigid_reduced_step, body, start(body, velocity, omega), 2, 50, loads);
  EXPECT_LT((body.inertia.centre(last.q) - box.centre() - 2 * velocity - 2 * g).norm(), 1e-13);
}

TEST(RigidMotion, steady_top_precesses_at_constant_tilt) {
  // A symmetric top steadily precesses when M g l = W (I3 w3 - I1 W cos(tilt)), W the precession, w3 the spin about its
  // axis in all; its attitude is exp(W t e_z) R0 exp((w3 - W cos(tilt)) t e_3), an exact solution.
  const Box top{{-0.5, -0.5, 0.5}, {0.5, 0.5, 0.7}, 3, {1, 1, 1}};
  const double tilt = 0.5, precession = 1.3, gravity = 9.81, l = 0.6, M = top.mass();
  const double I3 = top.principal()[2], I1 = top.principal()[0] + M * l * l;
  const double spin = (M * gravity * l / precession + I1 * precession * std::cos(tilt)) / I3;
  const Matrix3d R0 = Eigen::AngleAxisd(tilt, Vector3d::UnitX()).toRotationMatrix();
  const double own = spin - precession * std::cos(tilt);
  const auto exact = [&](double t) -> Matrix3d {
    return Eigen::AngleAxisd(precession * t, Vector3d::UnitZ()) * R0 * Eigen::AngleAxisd(own * t, Vector3d::UnitZ());
  };
  // The top's tip is fixed in the origin; the frame is given upright, and its state tilted.
  for (const RigidFrame& frame : {orthonormal(), skew()}) {
    const RigidBody body = body_of(top, frame, Vector3d::Zero());
    RigidState first = rigid_start(body, R0.transpose() * (precession * Vector3d::UnitZ()) + own * Vector3d::UnitZ());
    first.q = R0 * first.q, first.v = R0 * first.v;
    const auto loads = [&](double) { return rigid_gravity(body.inertia, {0, 0, -gravity}); };
    for (const Step step : {rigid_constrained_step, rigid_reduced_step}) {
      double error[3], tilted[3];
      for (int k = 0; k < 3; ++k) {
        const Matrix3d R = rotation(body, run(step, body, first, 1, 800 << k, loads));
        error[k] = (R - exact(1)).norm(), tilted[k] = std::abs(std::acos(R(2, 2)) - tilt);
      }
      EXPECT_LT(error[2], 5e-4);
      EXPECT_LT(tilted[2], 1e-6);
      EXPECT_NEAR(order(error[0], error[1]), 2, 0.1);
      EXPECT_NEAR(order(error[1], error[2]), 2, 0.1);
    }
  }
}

/// Places of three body points and of the centre after a long run.
Matrix3d corners(const RigidBody& body, const RigidState& state) {
  Matrix3d places;
  places << place(body, state, {0, 0, 0}), place(body, state, {1, 0, 0}), place(body, state, {0, 1, 1});
  return places;
}

TEST(RigidMotion, is_one_whatever_the_form_and_the_directors) {
  RigidFrame far = orthonormal({3, -2, 1}), left = skew();
  left.directors.col(0) *= -0.01;
  const Vector3d velocity(0.4, -0.3, 0.6), g(0.5, 0, -2);
  const std::vector<double> at{0.4, 0.4, 0.3}, thrust{0.1, -0.2, 0.05};
  for (const bool hangs : {false, true}) {
    std::optional<Matrix3d> first;
    for (const RigidFrame& frame : {orthonormal(box.centre()), orthonormal(), far, skew(), left}) {
      const RigidBody body = hangs ? body_of(box, frame, pin) : body_of(box, frame);
      const RigidForces weight = rigid_gravity(body.inertia, g);
      const RigidForces jet = rigid_point_forces(frame, at, thrust, RigidDirection::turning);
      const auto loads = [&](double t) {
        RigidForces sum = weight;
        return sum.add(jet, std::cos(t)).add(rigid_torque(torque_at(t)));
      };
      const RigidState begin = hangs ? rigid_start(body, omega) : start(body, velocity, omega);
      for (const Step step : {rigid_constrained_step, rigid_reduced_step}) {
        const Matrix3d places = corners(body, run(step, body, begin, 20, 2000, loads));
        if (!first) first = places;
        EXPECT_LT((places - *first).norm(), 1e-8 * first->norm());
      }
    }
  }
}

TEST(RigidMotion, of_a_plane_body_has_no_need_of_thickness) {
  // All mass in z = 0: E_33 is zero and the mass matrix singular, the motion is not.
  const std::vector<double> points{0, 0, 0, 1, 0, 0, 0, 2, 0, 1.5, 1, 0}, masses{1, 2, 1, 0.5};
  const RigidFrame frame = orthonormal();
  const RigidBody body = rigid_body(frame, rigid_inertia(frame, points, masses));
  const auto loads = [](double t) { return rigid_torque(10 * torque_at(t)); };
  const RigidState begin = rigid_start(body, {0.3, 0.1, 0}, omega);
  const RigidState a = run(rigid_constrained_step, body, begin, 10, 500, loads);
  const RigidState b = run(rigid_reduced_step, body, begin, 10, 500, loads);
  EXPECT_LT((a.q - b.q).norm(), 1e-10);
  EXPECT_GT((a.q - begin.q).norm(), 1);
}

}  // namespace
}  // namespace tether::fem
