// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/radial_gas.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace tether {
namespace {

using std::numbers::pi;

/// Thesis 4.2 with the radius of Box 2: pressure .4 * 250 = 100.
constexpr GasCylinder thesis_cylinder{0.376, 1, 250, 0.4};

double total_energy(const GasShells& shells) { return shells.kinetic_energy() + shells.internal_energy(); }

double mass_of(const GasShells& shells) {
  double sum = 0;
  for (const double m : shells.mass) sum += m;
  return sum;
}

double order(double coarse, double fine) { return std::log2(coarse / fine); }

TEST(RadialGas, begins_as_a_uniform_cylinder) {
  const GasShells start = shells_of(thesis_cylinder, 40);
  ASSERT_EQ(start.size(), 40u);
  EXPECT_NEAR(mass_of(start), pi * 0.376 * 0.376, 1e-14);
  EXPECT_NEAR(start.internal_energy(), 250 * pi * 0.376 * 0.376, 1e-12);
  EXPECT_EQ(start.kinetic_energy(), 0);
  EXPECT_NEAR(start.rms_radius(), 0.376 / std::sqrt(2), 1e-15);
  EXPECT_NEAR(start.radius_of_share(0.95), 0.376 * std::sqrt(0.95), 1e-14);
  EXPECT_EQ(start.radius_of_share(0), 0);
  EXPECT_NEAR(start.radius_of_share(1), 0.376, 1e-14);
  for (const std::size_t k : {0u, 17u, 39u}) EXPECT_NEAR(start.pressure(k), 100, 1e-11);
  EXPECT_EQ(expanded(start, 0).radius, start.radius);
}

TEST(RadialGas, keeps_mass_and_energy) {
  const GasShells start = shells_of(thesis_cylinder);
  for (const double t : {0.005, 0.02}) {
    const GasShells end = expanded(start, t);
    EXPECT_EQ(end.mass, start.mass);
    EXPECT_NEAR(total_energy(end) / total_energy(start), 1, 1e-12) << t;
    EXPECT_GT(end.kinetic_energy(), 0.05 * total_energy(start)) << t;
  }
}

/// The rms radius of the thesis' figures, at t = .005, and that of the mass' 95 %.
TEST(RadialGas, converges) {
  double rms[3], share[3];
  for (int k = 0; k < 3; ++k) {
    const GasShells end = expanded(shells_of(thesis_cylinder, 400 << k), 0.005);
    rms[k] = end.rms_radius(), share[k] = end.radius_of_share(0.95);
  }
  EXPECT_NEAR(rms[2], 0.27547, 5e-6);
  EXPECT_NEAR(share[2], 0.4107, 5e-5);
  EXPECT_GT(order(rms[1] - rms[0], rms[2] - rms[1]), 1.2);
  EXPECT_GT(order(share[1] - share[0], share[2] - share[1]), 1.0);
  // By Richardson, what is left with the default number of shells.
  EXPECT_LT(std::abs(rms[2] - rms[1]), 1e-6);
}

/// Half the second derivative of sum m r^2 is twice the kinetic energy and twice the pressure's integral, 2 (gamma - 1)
/// of the internal energy, while nothing acts from outside.
TEST(RadialGas, obeys_the_virial_theorem) {
  const double t = 0.004, h = 1e-4;
  const GasShells start = shells_of(thesis_cylinder);
  const auto moment = [&](double at) { return std::pow(expanded(start, at).rms_radius(), 2) * mass_of(start); };
  const GasShells now = expanded(start, t);
  const double acceleration = (moment(t + h) - 2 * moment(t) + moment(t - h)) / (h * h);
  EXPECT_NEAR(acceleration / 2 / (2 * now.kinetic_energy() + 2 * 0.4 * now.internal_energy()), 1, 1e-4);
}

/// gamma = 2, density 1, pressure 1 - a^2 in the unit circle: every place a moves as a s(t), as s'' = 2 s^-3 and s(0) =
/// 1 fulfil the momentum equation for all a at once; then s = sqrt(1 + 2 t^2).
GasShells parabola(int count) {
  GasShells shells = shells_of({1, 1, 1, 1}, count);
  for (std::size_t k = 0; k < shells.size(); ++k) {
    const double a = shells.radius[k], b = shells.radius[k + 1];
    shells.specific_energy[k] = 1 - (a * a + b * b) / 2;  // the shell's mean
  }
  return shells;
}

TEST(RadialGas, is_second_order_on_a_self_similar_expansion) {
  const double t = 2, stretch = std::sqrt(1 + 2 * t * t);
  double place_error[3] = {}, velocity_error[3] = {};
  for (int k = 0; k < 3; ++k) {
    const int count = 100 << k;
    const GasShells end = expanded(parabola(count), t);
    for (std::size_t face = 0; face < end.radius.size(); ++face) {
      const double a = static_cast<double>(face) / count;
      place_error[k] = std::fmax(place_error[k], std::abs(end.radius[face] - stretch * a));
      velocity_error[k] = std::fmax(velocity_error[k], std::abs(end.velocity[face] - 2 * t / stretch * a));
    }
  }
  EXPECT_LT(place_error[2], 1e-6);
  EXPECT_LT(velocity_error[2], 1e-7);
  EXPECT_GT(order(place_error[0], place_error[1]), 1.9);
  EXPECT_GT(order(place_error[1], place_error[2]), 1.9);
  EXPECT_GT(order(velocity_error[1], velocity_error[2]), 1.9);
}

/// Pressure is used up: gas that coasts is at r = u t, later the nearer.
TEST(RadialGas, coasts_in_the_end) {
  const GasShells start = shells_of(thesis_cylinder, 400);
  double farthest[2] = {};
  for (int k = 0; k < 2; ++k) {
    const double t = k == 0 ? 1 : 10;
    const GasShells end = expanded(start, t);
    for (std::size_t face = 1; face < end.radius.size(); ++face) {
      farthest[k] = std::fmax(farthest[k], std::abs(end.velocity[face] * t / end.radius[face] - 1));
    }
  }
  EXPECT_LT(farthest[0], 0.05);
  EXPECT_LT(farthest[1], 0.01);
  EXPECT_LT(farthest[1], farthest[0] / 4);
}

/// No gas is faster than into a vacuum through a plane, 2 c / (gamma - 1), which the outermost tends to.
TEST(RadialGas, front_is_slower_than_the_escape_speed) {
  const double escape = 2 * std::sqrt(1.4 * 100) / 0.4;
  double speed = 0;
  for (const int count : {400, 800, 1600}) {
    const double faster = expanded(shells_of(thesis_cylinder, count), 0.005).velocity.back();
    EXPECT_GT(faster, speed);
    EXPECT_LT(faster, escape);
    speed = faster;
  }
  EXPECT_GT(speed, 0.7 * escape);
}

/// W. F. Noh's implosion, J. Comput. Phys. 72 (1987) 78-120: cold gas, gamma = 5/3, that falls upon the axis at speed 1
/// stops in a shock that runs outwards at 1/3; density 16 within, 1 + t/r outside. The artificial viscosity at work.
double error_of_implosion(int count) {
  const double t = 0.6;
  GasShells shells = shells_of({1, 1, 1, 2.0 / 3}, count);
  for (double& energy : shells.specific_energy) energy = 0;
  for (std::size_t face = 1; face < shells.velocity.size(); ++face) shells.velocity[face] = -1;
  const GasShells end = expanded(shells, t);
  EXPECT_NEAR(total_energy(end) / total_energy(shells), 1, 1e-12);
  const RadialProfile profile = profile_of(end);
  double error = 0;
  for (std::size_t k = 0; k < end.size(); ++k) {
    const double r = profile.radius[k];
    error += std::abs(profile.density[k] - (r < t / 3 ? 16 : 1 + t / r)) * end.area(k);
  }
  return error;
}

TEST(RadialGas, first_order_across_a_shock) {
  const double coarse = error_of_implosion(200), fine = error_of_implosion(400);
  EXPECT_LT(fine, 0.1);  // of a mass of pi
  EXPECT_GT(order(coarse, fine), 0.9);
}

TEST(RadialGas, profile_stands_at_the_middles) {
  GasShells shells = shells_of({2, 3, 5, 0.5}, 2);
  shells.velocity = {0, 1, 4};
  const RadialProfile profile = profile_of(shells);
  EXPECT_EQ(profile.radius, (std::vector<double>{0.5, 1.5}));
  EXPECT_EQ(profile.velocity, (std::vector<double>{0.5, 2.5}));
  for (const std::size_t k : {0u, 1u}) {
    EXPECT_NEAR(profile.density[k], 3, 1e-14);
    EXPECT_NEAR(profile.pressure[k], 7.5, 1e-13);
    EXPECT_EQ(profile.specific_energy[k], 5);
  }
  EXPECT_NEAR(profile.mass_inside[0], 0.0625, 1e-15);  // (r/2)^2
  EXPECT_NEAR(profile.mass_inside[1], 0.5625, 1e-15);
}

TEST(RadialGas, refuses_what_is_no_gas) {
  for (const double wrong : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(shells_of({wrong, 1, 1, 0.4}), std::domain_error);
    EXPECT_THROW(shells_of({1, wrong, 1, 0.4}), std::domain_error);
    EXPECT_THROW(shells_of({1, 1, wrong, 0.4}), std::domain_error);
    EXPECT_THROW(shells_of({1, 1, 1, wrong}), std::domain_error);
  }
  EXPECT_THROW(shells_of(thesis_cylinder, 0), std::domain_error);
  EXPECT_THROW(expanded(shells_of(thesis_cylinder, 2), -1e-9), std::domain_error);
}

}  // namespace
}  // namespace tether
