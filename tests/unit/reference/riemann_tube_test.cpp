// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/riemann.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace tether {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();
const double sound = std::sqrt(1.4);  // of the density 1 and the pressure 1

RiemannTube tube_of(const GasState& left, const GasState& right, EndKind at_left = EndKind::wall,
                    EndKind at_right = EndKind::wall) {
  return {solve_riemann({left, right, 1.4, 0.5}), {0, at_left}, {1, at_right}};
}

/// Sod's: head of the rarefaction at sqrt(1.4), shock at 1.7522 (Toro's test 1).
TEST(RiemannTube, GasAtRestIsUndisturbedUntilTheFirstWaveArrives) {
  const RiemannTube sod = tube_of({1, 0, 1}, {0.125, 0, 0.1});
  EXPECT_NEAR(sod.left_begins(), 0.5 / sound, 1e-12);
  EXPECT_NEAR(sod.right_begins(), 0.5 / 1.75216, 1e-5);
  const TubePart whole = sod.valid_part(0.28);
  EXPECT_EQ(whole.from, 0);
  EXPECT_EQ(whole.to, 1);
}

/// Waves both ways, seen in a mirror.
TEST(RiemannTube, EndsAreAlikeInAMirror) {
  const RiemannTube sod = tube_of({1, 0, 1}, {0.125, 0, 0.1}), other = tube_of({0.125, 0, 0.1}, {1, 0, 1});
  EXPECT_DOUBLE_EQ(sod.left_begins(), other.right_begins());
  for (const double t : {0.3, 0.38}) {
    EXPECT_NEAR(sod.valid_part(t).from, 1 - other.valid_part(t).to, 1e-12);
    EXPECT_NEAR(sod.valid_part(t).to, 1 - other.valid_part(t).from, 1e-12);
  }
}

/// A shock meets a wall: the pressure that brings u* to rest again (Rankine and Hugoniot, Toro (3.53) and (3.57)).
TEST(RiemannTube, AShockComesBackAsAShock) {
  const RiemannTube sod = tube_of({1, 0, 1}, {0.125, 0, 0.1});
  const StarRegion& star = sod.solution.star;
  const double t = 0.3, back = (1 - sod.valid_part(t).to) / (t - sod.right_begins());
  // Mass through the shock sent back: rho* (u* + s) = rho3 s; momentum: p3 - p* = rho* (u* + s) u*.
  const double density = star.density_right * (star.velocity + back) / back;
  const double pressure = star.pressure + star.density_right * (star.velocity + back) * star.velocity;
  const auto energy = [](double p, double rho) { return p / (0.4 * rho); };
  EXPECT_NEAR(energy(pressure, density) - energy(star.pressure, star.density_right),
              0.5 * (pressure + star.pressure) * (1 / star.density_right - 1 / density), 1e-9);
  EXPECT_TRUE(sod.valid_part(0.6).empty());  // by then it has met the contact
}

TEST(RiemannTube, ARarefactionComesBackAlongTheCharacteristic) {
  const RiemannTube sod = tube_of({1, 0, 1}, {0.125, 0, 0.1});
  const double begin = sod.left_begins(), h = 1e-4;
  for (const double t : {begin + 0.01, begin + 0.05}) {
    const double slope = (sod.valid_part(t + h).from - sod.valid_part(t - h).from) / (2 * h);
    const GasSample gas = sample(sod.solution, sod.valid_part(t).from, t);
    EXPECT_NEAR(slope, gas.velocity + std::sqrt(1.4 * 0.4 * gas.specific_energy), 1e-5) << t;
  }
}

/// Toro's test 1 between walls: gas that runs away from a wall leaves a rarefaction, from the start.
TEST(RiemannTube, AWallDisturbsGasThatMovesFromTheStart) {
  const RiemannTube away = tube_of({1, 0.75, 1}, {0.125, 0, 0.1});
  EXPECT_EQ(away.left_begins(), 0);
  EXPECT_NEAR(away.valid_part(0.1).from, 0.1 * (0.75 + sound), 1e-9);
  const RiemannTube against = tube_of({1, -0.75, 1}, {0.125, -0.75, 0.1});
  EXPECT_GT(against.valid_part(0.1).from, 0.1 * (sound - 0.75));  // a shock is faster than sound
  EXPECT_LT(against.valid_part(0.1).from, 0.1 * sound);
}

TEST(RiemannTube, GasThatEndsInVacuumIsDisturbedFromTheStart) {
  const RiemannTube tube = tube_of({1, 0, 1}, {0.125, 0, 0.1}, EndKind::vacuum, EndKind::vacuum);
  EXPECT_EQ(tube.left_begins(), 0);
  EXPECT_EQ(tube.right_begins(), 0);
  EXPECT_NEAR(tube.valid_part(0.1).from, 0.1 * sound, 1e-9);
  EXPECT_NEAR(tube.valid_part(0.1).to, 1 - 0.1 * std::sqrt(1.4 * 0.8), 1e-9);
}

/// A stream through edges, Mach 2: no wave ever reaches the left one.
TEST(RiemannTube, EdgesThatGasPassesSendNothingUntilAWaveIsThere) {
  const RiemannTube slow = tube_of({1, 0.75, 1}, {0.125, 0, 0.1}, EndKind::edge, EndKind::edge);
  EXPECT_NEAR(slow.left_begins(), 0.5 / (sound - 0.75), 1e-9);
  EXPECT_EQ(slow.valid_part(0.2).from, 0);
  const RiemannTube fast = tube_of({1, 3, 1}, {1, 3, 1}, EndKind::edge, EndKind::edge);
  EXPECT_EQ(fast.left_begins(), never);
  EXPECT_EQ(fast.valid_part(10).from, 0);
}

}  // namespace
}  // namespace tether
