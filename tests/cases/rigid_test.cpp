// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "cases/rigid_support.hpp"

// Decks of rigid bodies: what they keep, Euler's equations, and that frame, form and kind of load do not matter.

namespace tether::cases {
namespace {

using namespace rigid;
using Texts = std::vector<std::string>;

/// Largest change of a column since the start.
double change(const DeckRun& run, const std::string& column) {
  const auto values = run.history.column(column);
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value - values.front()));
  return largest;
}

double change_of_vector(const DeckRun& run, const std::string& name) {
  double largest = 0;
  for (const char* axis : {"x", "y", "z"}) largest = std::max(largest, change(run, name + axis));
  return largest / last_of(run, name).norm();
}

TEST(RigidDecks, AFreeBodyKeepsEnergyAndMomentaOver100000Steps) {
  for (const char* form : {"'reduced'", "'constrained'"}) {
    SCOPED_TRACE(form);
    const DeckRun run = run_deck("rigid-free", {std::string("rigid.form=") + form});
    EXPECT_EQ(run.summary.at("steps"), 100000);
    EXPECT_LT(change(run, "energy_total") / run.last("energy_total"), 1e-12);
    EXPECT_LT(run.summary.at("energy_drift"), 1e-12);
    EXPECT_LT(change_of_vector(run, "momentum_"), 1e-12);
    EXPECT_LT(change_of_vector(run, "angular_momentum_"), 1e-12);
    EXPECT_LT(run.history.column("constraint_error").back(), 1e-12);
    // It turns over: the stem's end, at the bottom at first, gets to the top and back.
    const auto y = run.history.column("director_2_y");
    EXPECT_LT(*std::min_element(y.begin(), y.end()), -0.99);
    EXPECT_EQ(run.warnings, Texts{});
  }
}

const std::vector<Box> angle{{{0, 0, 0}, {3, 1, .6}, 1}, {{0, 1, 0}, {1, 2, .6}, 2}};
const Vector3d constant_torque(.3, -.8, .5);

Matrix3d skew_directors() {
  Matrix3d D;
  D << 1.2, .3, -.2, .4, .7, .5, -.1, .2, 1.6;
  return D;
}

TEST(RigidDecks, TheTorquesWorkIsTheEnergyGained) {
  for (const char* step : {"0.01", "0.1"}) {
    const DeckRun run = run_deck("rigid-torque", {std::string("in.tstep=") + step});
    const double gained = run.last("energy_total") - run.first("energy_total");
    EXPECT_GT(gained, 20 * run.first("energy_total"));
    EXPECT_LT(std::abs(run.last("energy_loads") / gained - 1), 1e-11);
    EXPECT_LT(run.summary.at("energy_drift"), 1e-11);
    // And its impulse the angular momentum, about any point, as the centre rests.
    const Vector3d first(run.first("angular_momentum_x"), run.first("angular_momentum_y"),
                         run.first("angular_momentum_z"));
    EXPECT_LT((last_of(run, "angular_momentum_") - first - 8 * constant_torque).norm() / first.norm(), 1e-11);
  }
}

/// A table's impulse is taken exactly where its times are those of steps: 1 to 0 over 4 is 2, loads being those of the
/// middle of each step.
TEST(RigidDecks, TablesActAtTheMiddleOfEachStep) {
  const DeckRun run =
      run_deck("rigid-torque", {"in.tstep=.1", "rigid.torque_time(1,1)=0.,4.", "rigid.torque_factor(1,1)=1.,0."});
  const Vector3d first(run.first("angular_momentum_x"), run.first("angular_momentum_y"),
                       run.first("angular_momentum_z"));
  EXPECT_LT((last_of(run, "angular_momentum_") - first - 2 * constant_torque).norm(), 1e-11);
}

TEST(RigidDecks, ATorquesMotionFollowsEulersEquationsBySecondOrder) {
  const Inertia inertia(angle);
  const Turning exact(inertia.moments, {.5, -.3, .2}, 8, [](double, const Matrix3d&) { return constant_torque; });
  std::array<double, 3> attitude{}, omega{};
  const char* steps[] = {"0.02", "0.01", "0.005"};
  for (std::size_t k = 0; k < 3; ++k) {
    const DeckRun run = run_deck("rigid-torque", {std::string("in.tstep=") + steps[k]});
    EXPECT_NEAR(run.last("mass"), inertia.mass, 1e-14);
    EXPECT_LT((last_of(run, "body_", "_1") - inertia.centre).norm(), 1e-13);
    attitude[k] = (directors(run) * skew_directors().inverse() - exact.rotation()).norm();
    omega[k] = (last_of(run, "omega_") - exact.omega()).norm() / exact.omega().norm();
  }
  expect_second_order(attitude, 2e-3);
  expect_second_order(omega, 2e-3);
}

/// Places of the body's centre and of the tracked node, and the angular velocity.
Eigen::Matrix<double, 9, 1> motion(const DeckRun& run) {
  Eigen::Matrix<double, 9, 1> all;
  all << last_of(run, "body_", "_1"), last_of(run, "point_", "_1"), last_of(run, "omega_");
  return all;
}

void expect_same_motion(const DeckRun& a, const DeckRun& b, double within) {
  EXPECT_LT((motion(a) - motion(b)).norm() / motion(b).norm(), within);
}

const Texts plain_frame{"rigid.point=1.2,.8,.3", "rigid.directors(1,1)=1.,0.,0.", "rigid.directors(1,2)=0.,1.,0.",
                        "rigid.directors(1,3)=0.,0.,1."};

/// A force at a point, one that turns, a torque, loads on a side and in a volume, weight, with tables; and with a pin.
TEST(RigidDecks, FrameAndFormDoNotMatter) {
  const Texts loads{"in.gravc=-.3",
                    "rigid.force(1,1)=.2,-.1,.3",
                    "rigid.force_at(1,1)=3.,1.,.6",
                    "rigid.force_time(1,1)=0.,2.,3.",
                    "rigid.force_factor(1,1)=0.,1.,-.5",
                    "rigid.force(1,2)=-.1,.2,.05",
                    "rigid.force_at(1,2)=0.,2.,0.",
                    "rigid.turning(2)=.true.",
                    "fem.load_on(1)='1.right'",
                    "fem.load(1,1)=.1,.2,-.3",
                    "fem.load_on(2)='region 2'",
                    "fem.load(1,2)=-.05,.1,.2",
                    "fem.load_time(1,2)=0.,4.",
                    "fem.load_factor(1,2)=1.,0."};
  for (const Texts& pin : {Texts{}, Texts{"rigid.pin=.5,.2,-.4"}}) {
    const Texts skew = with(loads, pin), plain = with(skew, plain_frame);
    const DeckRun run = run_deck("rigid-torque", skew);
    EXPECT_EQ(run.summary.at("unknowns"), pin.empty() ? 6 : 3);
    EXPECT_LT(run.summary.at("energy_drift"), 1e-11);
    const DeckRun multipliers = run_deck("rigid-torque", with(skew, {"rigid.form='constrained'"}));
    expect_same_motion(multipliers, run, 1e-9);
    EXPECT_NE(multipliers.summary.at("newton_iterations"), run.summary.at("newton_iterations"));
    EXPECT_EQ(multipliers.summary.at("unknowns"), pin.empty() ? 18 : 21);
    expect_same_motion(run_deck("rigid-torque", plain), run, 1e-9);
    expect_same_motion(run_deck("rigid-torque", with(plain, {"rigid.form='constrained'"})), run, 1e-9);
    if (!pin.empty()) {
      EXPECT_LT(run.last("pin_slip"), 1e-13);
    }
  }
}

/// What acts on sides and in volumes is the force at their centres; a weight is a load in the volume.
TEST(RigidDecks, LoadsAreForcesAtTheirCentres) {
  const DeckRun spread =
      run_deck("rigid-torque", {"in.gravc=-.3", "fem.load_on(1)='1.right'", "fem.load(1,1)=.1,.2,-.3",
                                "fem.load_on(2)='region 2'", "fem.load(1,2)=-.05,.1,.2"});
  const DeckRun single = run_deck(
      "rigid-torque", {"rigid.force(1,1)=.06,.12,-.18", "rigid.force_at(1,1)=3.,.5,.3", "rigid.force(1,2)=-.03,.06,.12",
                       "rigid.force_at(1,2)=.5,1.5,.3", "rigid.force(1,3)=0.,-.9,0.",  // M g, M = 1.8 + 1.2
                       "rigid.force_at(1,3)=1.1,.9,.3"});
  expect_same_motion(spread, single, 1e-11);
}

/// However small the masses and what acts on them, the motion is that of the deck.
TEST(RigidDecks, UnitsDoNotMatter) {
  const DeckRun run = run_deck("rigid-torque");
  const DeckRun tiny =
      run_deck("rigid-torque", {"reg.densir=1.d-200,2.d-200", "rigid.torque=.3d-200,-.8d-200,.5d-200"});
  expect_same_motion(tiny, run, 1e-11);
}

/// A force at the centre of a body that spins steadily, and turns with it, drives the centre along a cycloid.
TEST(RigidDecks, AForceThatTurnsGoesAlong) {
  const DeckRun run =
      run_deck("rigid-free", {"in.tmax=2.", "reg.vrx=4*0.", "rigid.omega=0.,0.,1.", "rigid.force=4.,0.,0.",
                              "rigid.force_at=0.,-.0833333333333333,0.", "rigid.turning=.true."});
  const double a = 4 / run.last("mass");  // v' = a (cos t, sin t): v = a (sin t, 1 - cos t)
  EXPECT_NEAR(run.last("body_vx_1"), a * std::sin(2.0), 1e-4);
  EXPECT_NEAR(run.last("body_vy_1"), a * (1 - std::cos(2.0)), 1e-4);
  EXPECT_NEAR(run.last("omega_z"), 1, 1e-10);
}

}  // namespace
}  // namespace tether::cases
