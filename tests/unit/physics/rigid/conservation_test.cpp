// SPDX-License-Identifier: GPL-3.0-or-later
// What the mid-point step keeps over very many steps: energy, momenta, constraints, the work of loads.
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <string>

#include "unit/physics/rigid/support.hpp"

namespace tether::fem {
namespace {

using namespace rigid;

constexpr int many = 100000;

/// About the intermediate axis, y of this box, and a little beside it: the body tumbles over again and again.
const Vector3d tumbling(0.05, 2, 0.02);
const Box plain_box;

struct Case {
  std::string name;
  Step step;
  RigidFrame frame;
  double dt;
  friend void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }
};

class RigidTumbling : public testing::TestWithParam<Case> {};

TEST_P(RigidTumbling, keeps_energy_and_angular_momentum) {
  const auto& [name, step, frame, dt] = GetParam();
  const RigidBody body = body_of(plain_box, frame);
  RigidState state = start(body, Vector3d::Zero(), tumbling);
  const double energy = rigid_kinetic_energy(body.inertia, state);
  const Vector3d momentum = rigid_angular_momentum(body.inertia, state);
  double energy_error = 0, momentum_error = 0, constraint_error = 0, drift = 0;
  int flips = 0, side = 1;
  double aside_early = 0, aside_late = 0;  // |G(q) v|
  for (int n = 0; n < many; ++n) {
    ASSERT_TRUE(step(body, {}, dt, state, {}).converged) << "step " << n;
    const Vector3d y = rotation(body, state).col(1);
    const int now = y.dot(momentum) > 0 ? 1 : -1;
    flips += now != side, side = now;
    energy_error = std::max(energy_error, std::abs(rigid_kinetic_energy(body.inertia, state) - energy));
    momentum_error = std::max(momentum_error, (rigid_angular_momentum(body.inertia, state) - momentum).norm());
    constraint_error = std::max(constraint_error, rigid_constraints(frame, state.q).norm());
    drift = std::max(drift, rigid_linear_momentum(body.inertia, state).norm());
    const double aside = rigid_constraint_rate(state.q.rightCols<3>(), state.v.rightCols<3>()).norm();
    (n < many / 2 ? aside_early : aside_late) = std::max(n < many / 2 ? aside_early : aside_late, aside);
  }
  EXPECT_GT(flips, static_cast<int>(many * dt / 20));
  EXPECT_LT(energy_error, 1e-11 * energy);
  EXPECT_LT(momentum_error, 1e-11 * momentum.norm());
  EXPECT_LT(constraint_error, 1e-13 * frame.directors.squaredNorm());
  EXPECT_LT(drift, 1e-12 * plain_box.mass() * tumbling.norm());
  // The velocities leave the constraints' tangent by O(dt^2) |omega|^3, and no further the longer it takes.
  EXPECT_LT(aside_late, 1.05 * aside_early);
  EXPECT_LT(aside_late, 0.1 * dt * dt * std::pow(tumbling.norm(), 3) * frame.directors.squaredNorm());
  RecordProperty("energy", std::to_string(std::log10(energy_error / energy)));
  RecordProperty("momentum", std::to_string(std::log10(momentum_error / momentum.norm())));
}

INSTANTIATE_TEST_SUITE_P(steps, RigidTumbling,
                         testing::Values(Case{"reduced", rigid_reduced_step, orthonormal(), 0.02},
                                         Case{"reduced_long_steps", rigid_reduced_step, orthonormal(), 0.3},
                                         Case{"reduced_skew", rigid_reduced_step, skew(), 0.02},
                                         Case{"constrained_skew", rigid_constrained_step, skew(), 0.02}),
                         [](const auto& info) { return info.param.name; });

TEST(RigidConservation, momenta_about_the_origin_of_a_body_that_flies_off) {
  const Vector3d velocity(0.3, -0.2, 0.1);
  for (const RigidFrame& frame : {orthonormal(), skew()}) {
    const RigidBody body = body_of(plain_box, frame);
    RigidState state = start(body, velocity, tumbling);
    const Vector3d momentum = rigid_angular_momentum(body.inertia, state), p = plain_box.mass() * velocity;
    for (int n = 0; n < many / 10; ++n) ASSERT_TRUE(rigid_reduced_step(body, {}, 0.02, state, {}).converged);
    EXPECT_LT((rigid_linear_momentum(body.inertia, state) - p).norm(), 1e-13 * p.norm());
    EXPECT_LT((rigid_angular_momentum(body.inertia, state) - momentum).norm(), 1e-11 * momentum.norm());
    EXPECT_LT((body.inertia.centre(state.q) - 0.02 * many / 10 * velocity).norm(), 1e-10);
  }
}

TEST(RigidConservation, velocities_beside_the_tangent_obey_their_recurrence) {
  // h1 = -h0 + (dt/4)(w1 - w0), h = G(q) v, w = G(v) v: what follows from (35) for what it does not constrain.
  const double dt = 0.05;
  const RigidBody body = body_of(plain_box, skew());
  RigidState state = start(body, Vector3d::Zero(), tumbling);
  const auto h = [&] { return rigid_constraint_rate(state.q.rightCols<3>(), state.v.rightCols<3>()); };
  const auto w = [&] { return rigid_constraint_rate(state.v.rightCols<3>(), state.v.rightCols<3>()); };
  for (int n = 0; n < 500; ++n) {
    const Eigen::Matrix<double, 6, 1> h0 = h(), w0 = w();
    ASSERT_TRUE(rigid_constrained_step(body, {}, dt, state, {}).converged);
    EXPECT_LT((h() + h0 - dt / 4 * (w() - w0)).norm(), 1e-12);
  }
  EXPECT_GT(h().norm() + w().norm(), 1e-3);  // there is something to obey
}

TEST(RigidConservation, work_of_a_torque_is_the_energy_gained) {
  const Vector3d torque(0.03, -0.02, 0.05);
  for (const Step step : {rigid_constrained_step, rigid_reduced_step}) {
    const RigidBody body = body_of(plain_box, skew());
    RigidState state = start(body, {0.2, 0.1, -0.3}, {0.3, 0.5, -0.4});
    const double before = rigid_kinetic_energy(body.inertia, state), dt = 0.02;
    double work = 0, turned = 0;
    for (int n = 0; n < 500; ++n) {
      const RigidReport report = step(body, rigid_torque(torque), dt, state, {});
      ASSERT_TRUE(report.converged);
      work += report.work, turned += dt * torque.dot(report.omega);  // m . delta phi
    }
    const double gained = rigid_kinetic_energy(body.inertia, state) - before;
    EXPECT_GT(std::abs(gained), 1);
    EXPECT_NEAR(work, gained, 1e-11 * std::abs(gained));
    EXPECT_NEAR(turned, gained, 1e-11 * std::abs(gained));
  }
}

TEST(RigidConservation, a_torque_changes_angular_momentum_by_its_impulse) {
  // Its factor in time is taken at the middle of each step: the impulse is the mid-point sum, whatever the directors.
  const Vector3d torque(0.3, -0.2, 0.5);
  const RigidBody body = body_of(plain_box, skew());
  RigidState state = start(body, {0.2, 0.1, -0.3}, {0.3, 0.5, -0.4});
  const Vector3d before = rigid_angular_momentum(body.inertia, state);
  Vector3d impulse = Vector3d::Zero();
  const double dt = 0.02;
  for (int n = 0; n < 1000; ++n) {
    const double factor = std::cos(3 * (n + 0.5) * dt);
    RigidForces loads;
    loads.add(rigid_torque(torque), factor);
    impulse += dt * factor * torque;
    ASSERT_TRUE(rigid_reduced_step(body, loads, dt, state, {}).converged);
  }
  EXPECT_LT((rigid_angular_momentum(body.inertia, state) - before - impulse).norm(), 1e-12);
}

TEST(RigidConservation, thrown_and_hanging_bodies_keep_their_total_energy) {
  const Vector3d g(0, 0, -9.81), pin(0.4, 0.3, 0.2);
  for (const Step step : {rigid_constrained_step, rigid_reduced_step}) {
    for (const bool hangs : {false, true}) {
      const RigidBody body = hangs ? body_of(plain_box, skew(), pin) : body_of(plain_box, skew());
      RigidState state = hangs ? rigid_start(body, tumbling) : start(body, {1, 2, 10}, tumbling);
      const auto energy = [&] {
        return rigid_kinetic_energy(body.inertia, state) + rigid_potential_energy(body.inertia, state, g);
      };
      const auto about_pin = [&] {  // angular momentum about the vertical through the fixed point
        return (rigid_angular_momentum(body.inertia, state) - pin.cross(rigid_linear_momentum(body.inertia, state)))[2];
      };
      const double before = energy(), vertical = about_pin(), dt = 0.01;
      const RigidForces weight = rigid_gravity(body.inertia, g);
      double error = 0, largest = 0;
      for (int n = 0; n < 20000; ++n) {
        ASSERT_TRUE(step(body, weight, dt, state, {}).converged);
        error = std::max(error, std::abs(energy() - before));
        largest = std::max(largest, rigid_kinetic_energy(body.inertia, state));
      }
      EXPECT_LT(error, 1e-11 * largest);
      if (!hangs) continue;
      EXPECT_NEAR(about_pin(), vertical, 1e-12);
      EXPECT_LT((place(body, state, pin) - pin).norm(), 1e-14);
      EXPECT_LT(rigid_constraints(body.frame, state.q).norm(), 1e-13);
    }
  }
}

}  // namespace
}  // namespace tether::fem
