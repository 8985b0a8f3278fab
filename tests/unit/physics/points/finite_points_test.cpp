// SPDX-License-Identifier: GPL-3.0-or-later
// Points that carry F: what turns, and what hangs at rest.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "unit/physics/points/robust_support.hpp"

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
  Scene scene = scene_on(BackgroundGrid(4 * N + 1, 4 * N + 1, -2, 2, -2, 2), all_walls(Wall::open), dt, robust_set());
  add_body(scene, law, lattice(0.5 * h, -0.5, 0.5, -0.5, 0.5), 1);
  set_velocities(scene, [&](double x, double y) { return Vec<2>{-spin * y, spin * x}; });
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

/// Takes all velocities away. A step that updates the stress first has not yet strained the points by what they moved
/// in it, which is then missing: steps are short here.
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
    const bool passed = kinetic < before;
    before = passed ? 0 : kinetic;
    if (passed) halt(run), --halts;
  }
}

/// A law of a column that is held across: stress dPsi/dl per area of the start, and energy, of its stretch l.
struct HangingColumn {
  FiniteElastic law;
  std::function<double(double)> stress, energy;
};

HangingColumn column_of_neo_hookean() {
  const Lame c = lame(E, nu);
  return {neo_hookean(), [c](double l) { return c.mu * (l - 1 / l) + c.lambda * std::log(l) / l; },
          [c](double l) {
            return 0.5 * c.mu * (l * l - 1 - 2 * std::log(l)) + 0.5 * c.lambda * std::log(l) * std::log(l);
          }};
}
HangingColumn column_of_st_venant_kirchhoff() {
  const double modulus = lame(E, nu).lambda + 2 * lame(E, nu).mu;
  return {st_venant_kirchhoff(), [modulus](double l) { return 0.5 * modulus * l * (l * l - 1); },
          [modulus](double l) { return 0.125 * modulus * (l * l - 1) * (l * l - 1); }};
}

double stretch_of(const HangingColumn& column, double stress) {
  double low = 1, high = 10;
  for (int k = 0; k < 100; ++k) (column.stress(0.5 * (low + high)) < stress ? low : high) = 0.5 * (low + high);
  return low;
}

/// How far the middle of a column of length 1 comes down that hangs, and its energy per area.
struct Hanging {
  double down = 0, stored = 0;
};
Hanging exact(const HangingColumn& column, double weight) {
  constexpr int n = 2000;
  Hanging hanging;
  double end = 0;
  for (int k = 0; k < n; ++k) {  // from the held end
    const double l = stretch_of(column, weight * (1 - (k + 0.5) / n));
    hanging.down += (end + 0.5 * (l - 1) / n) / n;
    hanging.stored += column.energy(l) / n;
    end += (l - 1) / n;
  }
  return hanging;
}

Hanging relaxed(const HangingColumn& column, double weight, int N) {
  const double h = 1.0 / N, dt = 0.05 * h / column.law.sound_speed(1);
  Walls walls = all_walls(Wall::free_slip);
  walls.top = Wall::fixed, walls.bottom = Wall::open;
  Scene scene = scene_on(BackgroundGrid(2, 5 * N / 2 + 1, 0, h, -1.5, 1), walls, dt, robust_set());
  scene.gravity = -weight;
  add_body(scene, column.law, lattice(0.25 * h, 0, h, 0, 1), 1);
  Running run(std::move(scene));
  const double start = run.value("body_y_1");
  relax(run, 10);
  return {start - run.value("body_y_1"), run.value("energy_strain") / h};
}

// Stretched to 1.5 at its upper end (St Venant-Kirchhoff, which stiffens: 1.3), with 16 points in a cell.
TEST(FinitePoints, AHangingColumnRestsWhereItsClosedFormSays) {
  constexpr double weight = 0.5;
  EXPECT_GT(stretch_of(column_of_neo_hookean(), weight), 1.45);
  for (const HangingColumn& column : {column_of_neo_hookean(), column_of_st_venant_kirchhoff()}) {
    const Hanging closed_form = exact(column, weight);
    double down = 1, stored = 1;
    for (const int N : {10, 20, 40}) {
      const Hanging found = relaxed(column, weight, N);
      const double down_now = std::abs(found.down / closed_form.down - 1),
                   stored_now = std::abs(found.stored / closed_form.stored - 1);
      RecordProperty("errors" + std::to_string(N), std::to_string(down_now) + " " + std::to_string(stored_now));
      EXPECT_LT(down_now, 0.75 * down) << N;
      EXPECT_LT(stored_now, 0.75 * stored) << N;
      down = down_now, stored = stored_now;
    }
    EXPECT_LT(down, 0.005);
    EXPECT_LT(stored, 0.01);
  }
}

}  // namespace
}  // namespace tether::mpm
