// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/oscillators.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace tether {
namespace {

using std::numbers::pi;

/// The rows of Box 7: from (0.33333, 0.9999) to (0.101, 0.303), at 18.44 degrees.
const Pendulum rows{std::hypot(0.23233, 0.6969), 20, std::atan2(0.23233, 0.6969)};

TEST(Pendulum, thesis_numbers) {
  EXPECT_NEAR(rows.start_angle * 180 / pi, 18.44, 5e-3);
  EXPECT_NEAR(rows.period(), 1.2120, 5e-5);
  // Table 1 of the thesis rounds the string to 0.73 and the angle to 19.8 degrees.
  EXPECT_NEAR((Pendulum{0.73, 20, 19.8 * pi / 180}.period()), 1.2094, 5e-5);
}

TEST(Pendulum, period_of_wide_swings) {
  // T/T0 = (2/pi) K(sin(theta0/2)); K(sin 45 deg) = Gamma(1/4)^2/(4 sqrt(pi)).
  const double gamma_quarter = std::tgamma(0.25);
  EXPECT_NEAR((Pendulum{1, 1, pi / 2}.period()), gamma_quarter * gamma_quarter / std::sqrt(pi), 1e-13);
  EXPECT_NEAR((Pendulum{1, 1, 0}.period()), 2 * pi, 1e-14);
  EXPECT_NEAR((Pendulum{1, 4, -pi / 2}.period()), (Pendulum{1, 4, pi / 2}.period()), 1e-14);
}

/// A rod alone, the string of a mass that is nothing against its own, swings as a string of two thirds of its length.
TEST(Pendulum, the_strings_own_mass_shortens_the_swing) {
  EXPECT_NEAR((Pendulum{1, 20, 0.3, 1e12}.period()), (Pendulum{2.0 / 3, 20, 0.3}.period()), 1e-10);
  EXPECT_NEAR((Pendulum{1, 20, 0.3, 0.06}.period()), (Pendulum{1.02 / 1.03, 20, 0.3}.period()), 1e-14);
}

TEST(Pendulum, angle_at_the_quarters_of_a_period) {
  const double period = rows.period(), start = rows.start_angle;
  EXPECT_NEAR(rows.angle(0), start, 1e-14);
  EXPECT_NEAR(rows.angle(period / 4), 0, 1e-14);
  EXPECT_NEAR(rows.angle(period / 2), -start, 1e-14);
  EXPECT_NEAR(rows.angle(period), start, 1e-14);
  EXPECT_NEAR(rows.angle(7.3 * period), rows.angle(0.3 * period), 1e-13);
}

TEST(Pendulum, negative_angle_mirrors_the_swing) {
  Pendulum other = rows;
  other.start_angle = -rows.start_angle;
  for (const double t : {0.0, 0.1, 0.4, 0.9}) EXPECT_NEAR(other.angle(t), -rows.angle(t), 1e-14);
}

TEST(Pendulum, obeys_its_equation_of_motion) {
  const Pendulum wide{0.7, 9.81, 3.0};
  const double h = 1e-4;
  for (const double t : {0.01, 0.3, 0.9, 1.4, 2.2}) {
    const double acceleration = (wide.angle(t + h) - 2 * wide.angle(t) + wide.angle(t - h)) / (h * h);
    EXPECT_NEAR(acceleration, -9.81 / 0.7 * std::sin(wide.angle(t)), 1e-4) << "at t = " << t;
  }
}

TEST(Pendulum, refuses_what_does_not_swing) {
  for (const double angle : {pi, -pi, 4.0, std::nan("")}) {
    EXPECT_THROW((Pendulum{1, 1, angle}.period()), std::domain_error);
    EXPECT_THROW((Pendulum{1, 1, angle}.angle(0.1)), std::domain_error);
  }
}

}  // namespace
}  // namespace tether
