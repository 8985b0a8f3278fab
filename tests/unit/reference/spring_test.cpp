// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/oscillators.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace tether {
namespace {

/// Thesis 5.5: A = 0.1, E = 1e6, L = 0.3, so k = A E/L.
const SpringMass thesis_spring{3.33, 0.1 * 1e6 / 0.3, 250};

TEST(Spring, thesis_numbers) {
  EXPECT_NEAR(thesis_spring.frequency(), 316.386, 5e-4);
  EXPECT_NEAR(thesis_spring.period(), 0.01985924, 5e-9);
  EXPECT_NEAR(thesis_spring.static_stretch(), 0.0024975, 1e-15);
  EXPECT_NEAR(thesis_spring.largest_drop(), 0.004995, 1e-15);
}

TEST(Spring, position_at_the_quarters_of_a_period) {
  const double period = thesis_spring.period();
  EXPECT_EQ(thesis_spring.position(0), 0);
  EXPECT_NEAR(thesis_spring.position(period / 4), -0.0024975, 1e-15);
  EXPECT_NEAR(thesis_spring.position(period / 2), -0.004995, 1e-15);
  EXPECT_NEAR(thesis_spring.position(period), 0, 1e-15);
  EXPECT_NEAR(thesis_spring.position(0.37 * period), thesis_spring.position(5.37 * period), 1e-14);
}

TEST(Spring, obeys_its_equation_of_motion) {
  const double h = 1e-5;
  for (const double t : {0.001, 0.004, 0.0123}) {
    const double acceleration =
        (thesis_spring.position(t + h) - 2 * thesis_spring.position(t) + thesis_spring.position(t - h)) / (h * h);
    const double force =
        -thesis_spring.mass * thesis_spring.gravity - thesis_spring.stiffness * thesis_spring.position(t);
    EXPECT_NEAR(thesis_spring.mass * acceleration, force, 1e-3);
  }
}

TEST(Spring, gravity_upwards_moves_the_mass_upwards) {
  const SpringMass up{2, 8, -3};
  EXPECT_NEAR(up.position(up.period() / 2), 1.5, 1e-14);
}

/// z tan(z) = M_s/m, solved here by Newton's method from the estimate of Rayleigh, m + M_s/3.
double first_root(double ratio) {
  double z = std::sqrt(ratio / (1 + ratio / 3));
  for (int k = 0; k < 50; ++k) {
    const double f = z * std::tan(z) - ratio, slope = std::tan(z) + z / (std::cos(z) * std::cos(z));
    z -= f / slope;
  }
  return z;
}

TEST(Spring, a_springs_own_mass_slows_it) {
  for (const double part : {1e-6, 1e-3, 0.1, 1.0}) {
    const SpringMass heavy{2, 8, 3, 2 * part};
    EXPECT_NEAR(heavy.frequency(), first_root(part) * std::sqrt(8 / (2 * part)), 1e-10 * heavy.frequency());
  }
  // Rayleigh: a third of the spring's mass swings with the mass.
  EXPECT_NEAR((SpringMass{2, 8, 3, 0.02}.frequency()), std::sqrt(8 / (2 + 0.02 / 3)), 1e-5);
  EXPECT_NEAR((SpringMass{2, 8, 3, 1e-9}.period()), (SpringMass{2, 8, 3}.period()), 1e-9);
}

/// Parts of the static stretch (m + M_s/2) g/k add up to it, and their accelerations to the fall at the start.
TEST(Spring, its_modes_are_the_whole_motion) {
  for (const double part : {0.01, 0.3, 1.0}) {
    const SpringMass heavy{2, 8, 3, 2 * part};
    const double period = heavy.period();
    double mean = 0;
    const int samples = 6000;
    std::vector<double> times;
    for (int k = 0; k < samples; ++k) times.push_back(60 * period * k / samples);
    for (const double y : heavy.positions(times)) mean += y / samples;
    EXPECT_NEAR(mean, -heavy.static_stretch(), 5e-3 * heavy.static_stretch()) << part;
    EXPECT_NEAR(heavy.position(0.01 * period), -1.5 * 1e-4 * period * period, 1e-2 * 1.5e-4 * period * period) << part;
    EXPECT_LE(heavy.largest_drop(5 * period), heavy.largest_drop());
    EXPECT_GT(heavy.largest_drop(5 * period), 0.98 * heavy.largest_drop());
    EXPECT_NEAR(heavy.largest_drop(), 2 * heavy.static_stretch(), 0.02 * heavy.static_stretch());
  }
}

/// A bar of 200 pieces with the mass at its end, each followed by the leapfrog rule.
TEST(Spring, moves_as_a_chain_of_many_pieces_does) {
  const int pieces = 200;
  const SpringMass heavy{2, 8, 3, 1};
  const double k = 8.0 * pieces, piece = 1.0 / pieces, dt = 0.2 * std::sqrt(piece / k);
  std::vector<double> u(pieces + 1, 0), v(u);
  double t = 0;
  while (t < 1.3 * heavy.period()) {
    for (std::size_t n = 1; n <= pieces; ++n) {
      const double mass = n == pieces ? 2 + piece / 2 : piece;
      const double force = k * (u[n - 1] - u[n]) + (n < pieces ? k * (u[n + 1] - u[n]) : 0);
      v[n] += dt * (3 + force / mass) * (t == 0 ? 0.5 : 1);
    }
    for (std::size_t n = 1; n <= pieces; ++n) u[n] += dt * v[n];
    t += dt;
  }
  EXPECT_NEAR(-u[pieces], heavy.position(t), 2e-4 * heavy.static_stretch());
}

}  // namespace
}  // namespace tether
