// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "base/diagnostics.hpp"
#include "cases/rigid_support.hpp"

// The heavy top, steady and nodding, and steps too long.

namespace tether::cases {
namespace {

using namespace rigid;

const std::vector<Box> top_plate{{{-.5, -.5, .4}, {.5, .5, .6}, 10}};
constexpr double top_gravity = 9.81, end = 6.4;

/// Moments about the pin, in the origin.
Matrix3d moments_about_pin() {
  Inertia inertia(top_plate);
  inertia.add_offset(inertia.mass, inertia.centre);
  return inertia.moments;
}

TEST(RigidTop, TheDecksSpinIsThatOfSteadyPrecession) {
  const Inertia inertia(top_plate);
  EXPECT_NEAR(inertia.mass * top_gravity * inertia.centre[2] / (moments_about_pin()(2, 2) * 30), .981, 1e-12);
}

/// The axis goes round in the horizontal plane by Omega t; how far it is off, along the plane and above it.
TEST(RigidTop, PrecessesSteadily) {
  std::array<double, 3> angle{}, height{};
  const char* steps[] = {"0.004", "0.002", "0.001"};
  for (std::size_t k = 0; k < 3; ++k) {
    const DeckRun run = run_deck("rigid-top", {std::string("in.tstep=") + steps[k]});
    EXPECT_EQ(run.summary.at("unknowns"), 3);
    const Vector3d axis = last_of(run, "point_", "_1") / .4;
    angle[k] = std::abs(std::remainder(std::atan2(axis[0], axis[2]) - .981 * end, 2 * std::numbers::pi));
    const auto y = run.history.column("point_y_1");
    height[k] = *std::max_element(y.begin(), y.end()) - *std::min_element(y.begin(), y.end());
    EXPECT_LT(run.last("pin_slip"), 1e-13);
    EXPECT_LT(run.summary.at("energy_growth"), 1 + 1e-12);
  }
  expect_second_order(angle, 1e-3);
  EXPECT_LT(height[0], 1e-4);
}

/// Let go with its spin alone it nods while it precesses.
TEST(RigidTop, NodsAsEulersEquationsSay) {
  const Inertia inertia(top_plate);
  const Turning exact(moments_about_pin(), {0, 0, 30}, end, [&](double, const Matrix3d& R) {
    return Vector3d((R * inertia.centre).cross(Vector3d(0, -inertia.mass * top_gravity, 0)));
  });
  std::array<double, 3> attitude{}, omega{};
  const char* steps[] = {"0.002", "0.001", "0.0005"};
  for (std::size_t k = 0; k < 3; ++k) {
    const DeckRun run = run_deck("rigid-top", {"rigid.omega=0.,0.,30.", std::string("in.tstep=") + steps[k]});
    attitude[k] = (directors(run) - exact.rotation()).norm();
    omega[k] = (last_of(run, "omega_") - exact.omega()).norm() / exact.omega().norm();
    EXPECT_LT(run.summary.at("energy_drift"), 1e-11);
  }
  expect_second_order(attitude, 1e-2);
  expect_second_order(omega, 1e-2);
}

/// Snapshots of the mesh: all distances stay, velocities stretch none, and displacements count from the start.
TEST(RigidTop, ItsMeshMovesAsABody) {
  const DeckRun run = run_deck("rigid-top", {"in.tmax=1."});
  const auto fields = [&](const std::string& name, std::size_t record) {
    constexpr std::size_t nodes = 27;
    Eigen::Matrix<double, 3, nodes> of;
    for (int i = 0; i < 3; ++i) {
      const auto all = read_variable(run.folder + "/mesh.nc", name + "xyz"[i]);
      EXPECT_EQ(all.size(), 6 * nodes);  // at 0, .2, ... 1
      for (std::size_t n = 0; n < nodes; ++n) of(i, static_cast<Eigen::Index>(n)) = all[record * nodes + n];
    }
    return of;
  };
  const auto x0 = fields("", 0), x1 = fields("", 5), v = fields("v", 5), u = fields("u", 5);
  EXPECT_GT(u.norm(), 1);
  EXPECT_LT((x0 + u - x1).norm(), 1e-14);
  for (Eigen::Index a = 0; a < x0.cols(); ++a) {
    for (Eigen::Index b = 0; b < a; ++b) {
      const Vector3d arm = x1.col(a) - x1.col(b);
      EXPECT_NEAR(arm.norm(), (x0.col(a) - x0.col(b)).norm(), 1e-13);
      EXPECT_NEAR(arm.dot(v.col(a) - v.col(b)), 0, 1e-12);
    }
  }
  const Vector3d tracked = last_of(run, "point_", "_1"), speed = last_of(run, "point_v", "_1");
  EXPECT_LT((x1.colwise() - tracked).colwise().norm().minCoeff(), 1e-15);
  EXPECT_LT((v.colwise() - speed).colwise().norm().minCoeff(), 1e-13);
  EXPECT_GT(speed.norm(), .39);
}

/// A step in which the body would turn by 3.5 rad does not converge; half of it or a quarter does.
TEST(RigidSteps, AreHalvedWhereTheyDoNotConverge) {
  const DeckRun run = run_deck("rigid-free", {"rigid.omega=1.,1.,.5", "in.tstep=2.", "in.tmax=200."});
  EXPECT_GT(run.summary.at("halvings"), 0);
  EXPECT_EQ(run.summary.at("steps"), 100 + run.summary.at("halvings"));
  EXPECT_LT(run.summary.at("energy_drift"), 1e-11);
  EXPECT_EQ(run.summary.at("time_end"), 200);
}

TEST(RigidSteps, ThatNeverConvergeAreToldWithTheirResiduals) {
  try {
    run_deck("rigid-torque", {"rigid.torque(1,1)=1.e9,1.e8,0."});
    FAIL() << "it ran";
  } catch (const RunError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("t = 0, step 1: Newton's method does not converge in a step of 0.000156, halved 6 times; "
                        "residuals over the terms of the balance 0."),
              std::string::npos)
        << text;
  }
}

}  // namespace
}  // namespace tether::cases
