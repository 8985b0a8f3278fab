// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/oscillators.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tether {
namespace {

/// Thesis 5.6: the spring of 5.5, with six of ten points at a strain of -0.1: 0.2 of string, 0.02 of slack.
const StringBounce thesis_bounce{3.33, 333333, 250, 0.02};

TEST(StringBounce, thesis_numbers) {
  EXPECT_NEAR(thesis_bounce.taut_time(), 0.01265, 5e-6);
  EXPECT_NEAR(thesis_bounce.lowest_time(), 0.01839, 5e-6);
  EXPECT_NEAR(thesis_bounce.slack_again_time(), 0.0241, 5e-5);
  EXPECT_NEAR(thesis_bounce.apex_time(), 0.0368, 5e-5);
  EXPECT_NEAR(thesis_bounce.largest_drop(), 0.0328, 5e-5);
}

TEST(StringBounce, position_at_its_turning_points) {
  EXPECT_EQ(thesis_bounce.position(0), 0);
  EXPECT_NEAR(thesis_bounce.position(thesis_bounce.taut_time()), -0.02, 1e-15);
  EXPECT_NEAR(thesis_bounce.position(thesis_bounce.lowest_time()), -thesis_bounce.largest_drop(), 1e-15);
  EXPECT_NEAR(thesis_bounce.position(thesis_bounce.slack_again_time()), -0.02, 1e-14);
  EXPECT_NEAR(thesis_bounce.position(thesis_bounce.apex_time()), 0, 1e-15);
  EXPECT_NEAR(thesis_bounce.position(3 * thesis_bounce.apex_time() + 0.005), -0.5 * 250 * 0.005 * 0.005, 1e-14);
}

TEST(StringBounce, lowest_point_stores_all_of_the_fall) {
  const double stretch = thesis_bounce.largest_drop() - thesis_bounce.slack;
  EXPECT_NEAR(0.5 * 333333 * stretch * stretch, 3.33 * 250 * thesis_bounce.largest_drop(), 1e-11);
}

TEST(StringBounce, obeys_its_equation_of_motion_slack_and_taut) {
  const double h = 1e-5;
  for (const double t : {0.005, 0.0127 + h, 0.016, 0.0184, 0.022, 0.03, 0.0368, 0.05}) {
    const double y = thesis_bounce.position(t);
    const double acceleration = (thesis_bounce.position(t + h) - 2 * y + thesis_bounce.position(t - h)) / (h * h);
    const double pull = y < -0.02 ? 333333 * (-y - 0.02) : 0;
    EXPECT_NEAR(3.33 * acceleration, pull - 3.33 * 250, 0.02) << "at t = " << t;
  }
}

TEST(StringBounce, without_slack_it_is_the_spring) {
  const StringBounce taut{3.33, 333333, 250, 0};
  const SpringMass spring{3.33, 333333, 250};
  EXPECT_EQ(taut.taut_time(), 0);
  EXPECT_NEAR(taut.apex_time(), spring.period(), 1e-15);
  for (const double t : {0.0, 0.003, 0.0099, 0.015, 0.07}) {
    EXPECT_NEAR(taut.position(t), spring.position(t), 1e-14);
  }
}

}  // namespace
}  // namespace tether
