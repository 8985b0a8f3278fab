// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/oscillators.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tether {
namespace {

using std::numbers::pi;

/// Thesis 6.1.2.
Piston thesis_piston(double mass) { return {mass, 100, 1, 20, 1e-4, 1.58e6}; }

TEST(Piston, thesis_table_3) {
  // The table's 886.2 is 2 pi over its rounded period .00709, its .02234 is 2 pi over its rounded 281.2.
  EXPECT_NEAR(thesis_piston(0.1).frequency(), 886.428043, 5e-7);
  EXPECT_NEAR(thesis_piston(0.1).period(), 0.00709, 5e-6);
  EXPECT_NEAR(thesis_piston(1).frequency(), 281.2, 0.05);
  EXPECT_NEAR(thesis_piston(1).period(), 0.02234, 1e-5);
}

TEST(Piston, solves_its_equation) {
  for (const double mass : {1e-4, 1e-3, 0.1, 1.0, 100.0}) {
    const Piston piston = thesis_piston(mass);
    const double omega = piston.frequency(), c = piston.sound_speed();
    const double right = 100 + 1e-4 * omega * c / std::tan(omega * 20 / c);
    EXPECT_NEAR(mass * omega * omega, right, 1e-9 * std::abs(1e-4 * omega * c) + 1e-9 * right);
    EXPECT_GT(omega, 0);
    EXPECT_LT(omega, pi * c / 20);
  }
}

TEST(Piston, weightless_piston_without_spring_is_a_quarter_wave) {
  const Piston open{0, 0, 1, 20, 1e-4, 1.58e6};
  EXPECT_NEAR(open.period(), 4 * 20 / open.sound_speed(), 1e-15);
}

TEST(Piston, heavy_piston_sees_the_fluid_as_a_spring) {
  // z cot z = 1 - z^2/3 ...: one third of the fluid's mass moves with the piston.
  const double stiffness = 100 + 1.58e6 / 20, mass = 1e4 + 1e-4 * 20 / 3;
  EXPECT_NEAR(thesis_piston(1e4).frequency(), std::sqrt(stiffness / mass), 1e-10);
}

TEST(Piston, held_piston_leaves_the_half_wave_of_the_fluid) {
  const Piston held{1e-6, 1e12, 1, 20, 1e-4, 1.58e6};
  EXPECT_NEAR(held.frequency(), pi * held.sound_speed() / 20, 0.01);
}

}  // namespace
}  // namespace tether
