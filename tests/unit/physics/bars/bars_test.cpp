// SPDX-License-Identifier: GPL-3.0-or-later
// Bars by central differences against exact solutions, and what they must conserve.
#include <gtest/gtest.h>

#include "base/diagnostics.hpp"
#include "unit/physics/bars/support.hpp"

namespace tether::fem {
namespace {

using namespace scenes;

double order(double coarse, double fine) { return std::log2(std::abs(coarse / fine)); }

/// Time at which a quantity that begins as a cosine comes through zero for the k-th time, over k - 1/2: half a period.
double half_period(const std::vector<double>& time, const std::vector<double>& values, int passages) {
  int found = 0;
  for (std::size_t k = 1; k < values.size(); ++k) {
    if ((values[k - 1] > 0) == (values[k] > 0)) continue;
    if (++found < passages) continue;
    const double at = time[k - 1] + (time[k] - time[k - 1]) * values[k - 1] / (values[k - 1] - values[k]);
    return at / (passages - 0.5);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

double axial_error(std::size_t n, double cfl) {
  const double exact = length / c;
  RunningBars run(vibrating_bar(n, cfl));
  run.until(6.2 * exact);
  return half_period(run.column("time"), run.column("point_vx_1"), 6) / exact - 1;
}

TEST(AxialVibration, ConvergesToTheBarsFrequencyInSecondOrder) {
  const double coarse = axial_error(8, 0.5), middle = axial_error(16, 0.5), fine = axial_error(32, 0.5);
  EXPECT_LT(std::abs(coarse), 6e-3);
  EXPECT_LT(std::abs(fine), 4e-4);
  EXPECT_NEAR(order(coarse, middle), 2, 0.1);
  EXPECT_NEAR(order(middle, fine), 2, 0.05);
}

// The wave runs from point to point in one step of dx/c, and errors in space and time cancel.
TEST(AxialVibration, IsExactAtTheLimit) { EXPECT_NEAR(axial_error(12, 1), 0, 1e-10); }

TEST(AxialVibration, GrowsJustAboveTheLimit) {
  Scene scene = vibrating_bar(12, 1.02);
  EXPECT_THROW(RunningBars(scene).solver().advance(200), RunError);
  scene.clock.cfl = 0.99;
  RunningBars run(scene);
  run.until(50);
  EXPECT_LT(run.now("energy_kinetic"), 1.01 * run.column("energy_kinetic").front());
}

/// Of a string under the stress sigma between two pins, its first mode across: omega = (pi / L) sqrt(sigma / rho).
double transverse_error(std::size_t n) {
  const double sigma = 4, a = 1e-4, exact = length / std::sqrt(sigma / rho);
  Scene scene = fem_scene(20);
  scene.clock.cfl = 0.5;
  const double h = length / static_cast<double>(n), volume = section * h;
  add_string(scene, {E, 0, true}, row(3, 5, h, 0, n + 1), volume, rho * volume);
  for (std::size_t p = 0; p <= n; ++p) {
    scene.points.y[p] += a * std::sin(pi * static_cast<double>(p) / static_cast<double>(n));
    scene.points.sxx[p] = sigma;
  }
  scene.points.volume.front() /= 2, scene.points.volume.back() /= 2;
  scene.pinned = {0, n}, scene.tracked = {n / 2};
  RunningBars run(scene);
  run.until(4.2 * exact);
  auto y = run.column("point_y_1");
  for (double& value : y) value -= 5;
  return half_period(run.column("time"), y, 4) / exact - 1;
}

TEST(TransverseVibration, ConvergesToTheStringsFrequencyInSecondOrder) {
  const double coarse = transverse_error(8), middle = transverse_error(16), fine = transverse_error(32);
  EXPECT_LT(std::abs(fine), 5e-4);
  EXPECT_NEAR(order(coarse, middle), 2, 0.1);
  EXPECT_NEAR(order(middle, fine), 2, 0.1);
}

TEST(BarEnergy, OfLinearBarsIsKeptToTheLastDigits) {
  Scene scene = vibrating_bar(12, 0.9);
  scene.points.vx[3] += 0.03, scene.points.vy[3] += 0.04;  // high modes, too
  scene.gravity = -0.3;
  RunningBars run(scene);
  run.until(20);
  const auto total = run.column("energy_total"), of_step = run.column("energy_step");
  const double scale = run.column("energy_kinetic").front();
  EXPECT_LT(largest_change(total), 1e-9 * scale);  // they stay in line, and no angle makes them non-linear
  std::vector<double> plain = total;
  for (std::size_t k = 0; k < plain.size(); ++k) plain[k] -= of_step[k];
  EXPECT_GT(largest_change(plain), 0.05 * scale);
}

TEST(BarEnergy, OfAStraightBarIsKeptAlsoByACutLastStep) {
  RunningBars run(level_bar(7.013));
  run.until(8);
  EXPECT_EQ(run.now("time"), 7.013);
  EXPECT_LT(run.now("dt"), 0.9 * run.plan().step.first_step());
  EXPECT_LT(largest_change(run.column("energy_total")), 1e-12 * run.column("energy_kinetic").front());
}

TEST(BarEnergy, LosesNothingWhereTheBarsStretchMuch) {
  const auto drift = [](double cfl) {
    Scene scene = free_string(16, cfl, true);
    for (std::size_t p = 0; p < 16; ++p) {
      const double s = (static_cast<double>(p) - 7.5) / 8;
      scene.points.vx[p] = -4 * s, scene.points.vy[p] = 3 * s * s;  // it turns, bends and goes slack
    }
    RunningBars run(scene);
    run.until(8);
    return largest_change(run.column("energy_total")) / run.column("energy_kinetic").front();
  };
  const double coarse = drift(0.4), fine = drift(0.1);
  EXPECT_LT(coarse, 0.02);
  EXPECT_LT(fine, coarse / 4);
}

TEST(BarMomentum, OfAFreeStringIsKept) {
  Scene scene = free_string(16, 0.9, true);
  for (std::size_t p = 0; p < 16; ++p) {
    const auto s = static_cast<double>(p);
    scene.points.vx[p] = 0.5 + std::sin(s), scene.points.vy[p] = std::cos(2 * s);
    scene.points.mass[p] *= 1 + 0.5 * std::sin(5 * s);
  }
  RunningBars run(scene);
  run.until(10);
  const double scale = 0.5 * run.now("mass");
  EXPECT_LT(largest_change(run.column("momentum_x")), 1e-12 * scale);
  EXPECT_LT(largest_change(run.column("momentum_y")), 1e-12 * scale);
  EXPECT_LT(largest_change(run.column("angular_momentum_z")), 1e-12 * 20 * scale);
  EXPECT_EQ(largest_change(run.column("mass")), 0);
  EXPECT_GT(largest_change(run.column("energy_strain")), 0.1);  // it was shaken
}

TEST(SlackString, FallsFreely) {
  Scene scene = free_string(10, 0.9, true);
  scene.gravity = -2;
  for (std::size_t p = 0; p < 10; ++p) {
    scene.points.sxx[p] = -0.1 * E * 0.36, scene.points.syy[p] = -0.1 * E * 0.64, scene.points.sxy[p] = -0.1 * E * 0.48;
  }
  scene.tracked = {0, 9};
  RunningBars run(scene);
  run.until(3);
  const double t = run.now("time");
  for (const int k : {1, 2}) {
    const auto name = "point_y_" + std::to_string(k);
    EXPECT_NEAR(run.now(name), run.column(name).front() - t * t, 1e-11);
  }
  EXPECT_EQ(run.now("energy_strain"), 0);
  EXPECT_NEAR(run.field("strain", 4), -0.1, 1e-12);
  EXPECT_EQ(run.field("stress", 4), 0);
}

/// Two masses of 1 on a bar of length 1, stiffness 200 and 0.2 of slack, which come together with 2 v.
Scene two_masses(bool wrinkle, double v, double slack = 0.2) {
  Scene scene = fem_scene(20);
  scene.clock.cfl = 0.02;
  add_string(scene, {E, 0, wrinkle}, row(5, 5, 1, 0, 2), section, 1);
  scene.points.vx = {v, -v};
  scene.points.sxx = {-slack * E, -slack * E};
  scene.tracked = {0, 1};
  return scene;
}

// Strain goes on accumulating: the masses pass free of force to within the slack, turn nothing, and come apart until
// the bar is taut again at 1.2; a two-way bar throws them back at once.
TEST(OneWayLaw, PullsOnlyBeyondTheLengthThatTheSlackAllows) {
  RunningBars run(two_masses(true, -0.5));  // apart
  run.until(0.19);
  EXPECT_EQ(run.now("point_vx_1"), -0.5);  // taut at 0.2
  run.until(0.21);
  EXPECT_GT(run.now("point_vx_1"), -0.5);
  const double omega = std::sqrt(2 * E * section / 1.0);
  run.until(0.2 + pi / omega + 0.02);  // half a swing on the bar
  EXPECT_NEAR(run.now("point_vx_1"), 0.5, 1e-3);
  EXPECT_NEAR(run.now("point_vx_2"), -0.5, 1e-3);
  run.until(0.8);
  EXPECT_NEAR(run.field("strain", 0), (run.now("point_x_2") - run.now("point_x_1")) - 1 - 0.2, 1e-12);
  EXPECT_LT(run.field("strain", 0), -0.2);
  EXPECT_EQ(run.field("stress", 0), 0);
}

TEST(OneWayLaw, TheTwoWayLawPushes) {
  RunningBars slack(two_masses(true, 0.1, 0)), stiff(two_masses(false, 0.1, 0));
  EXPECT_EQ(slack.until(0.1).now("point_vx_1"), 0.1);
  EXPECT_LT(stiff.until(0.1).now("point_vx_1"), 0.1);
  EXPECT_LT(stiff.field("stress", 0), 0);
  EXPECT_GT(stiff.now("energy_strain"), 0);
}

}  // namespace
}  // namespace tether::fem
