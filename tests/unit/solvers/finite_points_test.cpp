// SPDX-License-Identifier: GPL-3.0-or-later
// Points that carry F: what turns, what hangs at rest, what collides.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/errors.hpp"
#include "unit/solvers/robust_support.hpp"

namespace tether::mpm {
namespace {

using namespace scenes;

constexpr double E = 1, nu = 0.3;

FiniteElastic neo_hookean(Plane plane = Plane::strain) {
  return {NeoHookean::of({.E = E, .nu = nu, .plane = plane}), E, nu};
}
FiniteElastic st_venant_kirchhoff(Plane plane = Plane::strain) {
  return {StVenantKirchhoff::of({.E = E, .nu = nu, .plane = plane}), E, nu};
}

struct Turn {
  double angular = 0, energy = 0, integration = 0;  // each against its start
};

/// A free square of N cells that turns once; of its energy what the first step left counts as the start: points begin
/// without a field about them.
Turn turned(const Material& law, int N, double cfl) {
  const double spin = 0.3, h = 1.0 / N, dt = cfl * h / neo_hookean().sound_speed(1);
  Scene scene =
      scene_on(BackgroundGrid(4 * N + 1, 4 * N + 1, -2, 2, -2, 2), all_walls(Wall::open), dt, robust_method());
  add_body(scene, law, lattice(0.5 * h, -0.5, 0.5, -0.5, 0.5), 1);
  set_velocities(scene, [&](double x, double y) { return Vec2{-spin * y, spin * x}; });
  Running run(std::move(scene));
  const double angular = run.value("angular_momentum_z");
  run.steps(1);
  const double energy = run.value("energy_total");
  run.until(2 * std::numbers::pi / spin);
  return {run.value("angular_momentum_z") / angular - 1, run.value("energy_total") / energy - 1,
          run.value("energy_integration") / energy};
}

// The rate form, whose stress does not turn, gains 7 % in the same turn.
TEST(FinitePoints, ATurnedBlockKeepsAngularMomentumAndEnergy) {
  for (const FiniteElastic& law : {neo_hookean(), st_venant_kirchhoff(), neo_hookean(Plane::stress)}) {
    const Turn coarse = turned(law, 10, 0.5), shorter = turned(law, 10, 0.125), finer = turned(law, 20, 0.25);
    for (const Turn& turn : {coarse, shorter, finer}) {
      EXPECT_LT(std::abs(turn.angular), 1e-12);
      EXPECT_LT(std::abs(turn.energy), 0.01);
    }
    RecordProperty("turns", std::to_string(coarse.energy) + " " + std::to_string(shorter.energy) + " " +
                                std::to_string(finer.energy));
    EXPECT_LT(std::abs(shorter.energy), std::abs(coarse.energy));
    EXPECT_LT(std::abs(finer.energy), 0.5 * std::abs(coarse.energy));
    EXPECT_LT(std::abs(shorter.integration), 0.5 * std::abs(coarse.integration));
  }
}

/// Takes all velocities away.
void halt(Running& run) {
  SavedState saved = run.solver().save();
  for (const char* name : {"vx", "vy", "vxx", "vyx", "vxy", "vyy", "node_momentum_x", "node_momentum_y"})
    std::ranges::fill(saved.at(name), 0.0);
  run.solver().restore(saved);
}

/// To rest, by halting whenever the kinetic energy has passed a peak.
void relax(Running& run, int halts) {
  for (double before = 0; halts > 0;) {
    run.steps(1);
    const double kinetic = run.value("energy_kinetic");
    if (kinetic < before)
      halt(run), --halts, before = 0;
    else
      before = kinetic;
  }
}

/// Stretch l at which a column that is held across carries the stress P = dPsi/dl per area of the start.
template <class Stress>
double stretch_of(double P, const Stress& stress) {
  double low = 0.2, high = 10;
  for (int k = 0; k < 100; ++k) (stress(0.5 * (low + high)) < P ? low : high) = 0.5 * (low + high);
  return low;
}

/// Mean displacement over the length of a column of length 1 that hangs under its own weight rho g = `weight`, and
/// its energy per area.
template <class Stress, class Energy>
std::array<double, 2> hanging(double weight, const Stress& stress, const Energy& energy) {
  constexpr int n = 2000;
  double down = 0, mean = 0, stored = 0;
  for (int k = 0; k < n; ++k) {  // from the held end
    const double l = stretch_of(weight * (1 - (k + 0.5) / n), stress);
    mean += (down + 0.5 * (l - 1) / n) / n;
    down += (l - 1) / n;
    stored += energy(l) / n;
  }
  return {mean, stored};
}

struct Hung {
  double down = 0, stored = 0;
};
Hung hung(const Material& law, int N, double weight) {
  const double h = 1.0 / N, dt = 0.02 * h / neo_hookean().sound_speed(1);
  Walls walls = all_walls(Wall::free_slip);
  walls.top = Wall::fixed, walls.bottom = Wall::open;
  Scene scene = scene_on(BackgroundGrid(2, 5 * N / 2 + 1, 0, h, -1.5, 1), walls, dt, robust_method());
  scene.gravity = -weight;
  add_body(scene, law, lattice(0.5 * h, 0, h, 0, 1), 1);
  Running run(std::move(scene));
  const double start = run.value("body_y_1");
  relax(run, 25);
  return {start - run.value("body_y_1"), run.value("energy_strain") / h};
}

// Under its weight the column's upper end is stretched by .6.
TEST(FinitePoints, AHangingColumnRestsWhereItsClosedFormSays) {
  const Lame l = lame(E, nu);
  const double weight = 0.5;
  const auto stress = [&](double a) { return l.mu * (a - 1 / a) + l.lambda * std::log(a) / a; };
  const auto energy = [&](double a) {
    return 0.5 * l.mu * (a * a - 1 - 2 * std::log(a)) + 0.5 * l.lambda * std::log(a) * std::log(a);
  };
  const auto [down, stored] = hanging(weight, stress, energy);
  EXPECT_GT(stretch_of(weight, stress), 1.1);
  double before = 1;
  for (const int N : {10, 20, 40}) {
    const Hung found = hung(neo_hookean(), N, weight);
    const double error = std::abs(found.down / down - 1);
    std::printf("N %d down %.6g (%.6g) error %.3e stored %.3e\n", N, found.down, down, error,
                found.stored / stored - 1);
    EXPECT_LT(error, 0.7 * before);
    before = error;
  }
  EXPECT_LT(before, 0.01);
}

TEST(FinitePoints, AHangingStVenantKirchhoffColumn) {
  const Lame l = lame(E, nu);
  const double weight = 0.5, M = l.lambda + 2 * l.mu;
  const auto [down, stored] = hanging(
      weight, [&](double a) { return 0.5 * M * a * (a * a - 1); },
      [&](double a) { return 0.125 * M * (a * a - 1) * (a * a - 1); });
  double before = 1;
  for (const int N : {10, 20, 40}) {
    const Hung found = hung(st_venant_kirchhoff(), N, weight);
    const double error = std::abs(found.down / down - 1);
    std::printf("N %d down %.6g (%.6g) error %.3e stored %.3e\n", N, found.down, down, error,
                found.stored / stored - 1);
    EXPECT_LT(error, 0.7 * before);
    before = error;
  }
  EXPECT_LT(before, 0.01);
}

}  // namespace
}  // namespace tether::mpm
