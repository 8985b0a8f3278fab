// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/spring.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tether {
namespace {

/// Thesis 5.5: A = 0.1, E = 1e6, L = 0.3, so k = A E/L.
const SpringMass thesis{3.33, 0.1 * 1e6 / 0.3, 250};

TEST(Spring, thesis_numbers) {
  EXPECT_NEAR(thesis.frequency(), 316.386, 5e-4);
  EXPECT_NEAR(thesis.period(), 0.01985924, 5e-9);
  EXPECT_NEAR(thesis.static_stretch(), 0.0024975, 1e-15);
  EXPECT_NEAR(thesis.largest_drop(), 0.004995, 1e-15);
}

TEST(Spring, position_at_the_quarters_of_a_period) {
  const double period = thesis.period();
  EXPECT_EQ(thesis.position(0), 0);
  EXPECT_NEAR(thesis.position(period / 4), -0.0024975, 1e-15);
  EXPECT_NEAR(thesis.position(period / 2), -0.004995, 1e-15);
  EXPECT_NEAR(thesis.position(period), 0, 1e-15);
  EXPECT_NEAR(thesis.position(0.37 * period), thesis.position(5.37 * period), 1e-14);
}

TEST(Spring, obeys_its_equation_of_motion) {
  const double h = 1e-5;
  for (const double t : {0.001, 0.004, 0.0123}) {
    const double acceleration = (thesis.position(t + h) - 2 * thesis.position(t) + thesis.position(t - h)) / (h * h);
    const double force = -thesis.mass * thesis.gravity - thesis.stiffness * thesis.position(t);
    EXPECT_NEAR(thesis.mass * acceleration, force, 1e-3);
  }
}

TEST(Spring, gravity_upwards_moves_the_mass_upwards) {
  const SpringMass up{2, 8, -3};
  EXPECT_NEAR(up.position(up.period() / 2), 1.5, 1e-14);
}

}  // namespace
}  // namespace tether
