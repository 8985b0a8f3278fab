// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/riemann.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace tether {
namespace {

const RiemannProblem sod{{1, 0, 1}, {0.125, 0, 0.1}, 1.4, 0.5};

/// A row of Toro's Tables 4.1 and 4.3: the states and what stands between them, as many digits as printed.
/// The last row starts from rounded numbers, and the printed pressure and velocity are off in their last digit.
struct ToroTest {
  GasState left, right;
  StarRegion star;
  StarRegion tolerance;  ///< half a unit of the last printed digit
};

const ToroTest toro_tests[] = {
    {{1, 0, 1}, {0.125, 0, 0.1}, {0.30313, 0.92745, 0.42632, 0.26557}, {5e-6, 5e-6, 5e-6, 5e-6}},
    {{1, -2, 0.4}, {1, 2, 0.4}, {0.00189, 0, 0.02185, 0.02185}, {5e-6, 5e-6, 5e-6, 5e-6}},
    {{1, 0, 1000}, {1, 0, 0.01}, {460.894, 19.5975, 0.57506, 5.99924}, {5e-4, 5e-5, 5e-6, 5e-6}},
    {{1, 0, 0.01}, {1, 0, 100}, {46.0950, -6.19633, 5.99242, 0.57511}, {5e-5, 5e-6, 5e-6, 5e-6}},
    {{5.99924, 19.5975, 460.894},
     {5.99242, -6.19633, 46.0950},
     {1691.64, 8.68975, 14.2823, 31.0426},
     {1e-2, 3e-5, 5e-5, 5e-5}},
};

class ToroStar : public testing::TestWithParam<ToroTest> {};

TEST_P(ToroStar, agrees_with_the_printed_values) {
  const auto& [left, right, expected, tolerance] = GetParam();
  const StarRegion star = solve_riemann({left, right, 1.4, 0}).star;
  EXPECT_NEAR(star.pressure, expected.pressure, tolerance.pressure);
  EXPECT_NEAR(star.velocity, expected.velocity, tolerance.velocity);
  EXPECT_NEAR(star.density_left, expected.density_left, tolerance.density_left);
  EXPECT_NEAR(star.density_right, expected.density_right, tolerance.density_right);
}

INSTANTIATE_TEST_SUITE_P(tests_1_to_5, ToroStar, testing::ValuesIn(toro_tests));

/// Mass, momentum and energy that pass a front which moves at `speed`, per area and time.
struct Flux {
  double mass, momentum, energy;
};

Flux flux_through(const GasSample& gas, double speed) {
  const double relative = gas.velocity - speed;
  const double total_energy = gas.density * (gas.specific_energy + gas.velocity * gas.velocity / 2);
  return {gas.density * relative, gas.density * gas.velocity * relative + gas.pressure,
          total_energy * relative + gas.pressure * gas.velocity};
}

void expect_no_loss_over_front(const RiemannSolution& solution, double speed) {
  const double t = 0.1, x = solution.problem.diaphragm + speed * t, aside = 1e-9;
  const GasSample before = sample(solution, x - aside, t), behind = sample(solution, x + aside, t);
  ASSERT_GT(std::abs(before.pressure - behind.pressure), 0.1) << "no shock at this speed";
  const Flux a = flux_through(before, speed), b = flux_through(behind, speed);
  EXPECT_NEAR(a.mass, b.mass, 1e-12 * std::abs(a.mass));
  EXPECT_NEAR(a.momentum, b.momentum, 1e-12 * std::abs(a.momentum));
  EXPECT_NEAR(a.energy, b.energy, 1e-12 * std::abs(a.energy));
}

/// Speed of the shock between the star state and an outer state, from mass alone.
double shock_speed(double star_density, double star_velocity, const GasState& outer) {
  return (star_density * star_velocity - outer.density * outer.velocity) / (star_density - outer.density);
}

TEST(Riemann, sod_shock_obeys_rankine_hugoniot) {
  const auto solution = solve_riemann(sod);
  const double speed = shock_speed(solution.star.density_right, solution.star.velocity, sod.right);
  EXPECT_NEAR(speed, 1.75216, 5e-6);
  expect_no_loss_over_front(solution, speed);
}

TEST(Riemann, both_shocks_of_two_obey_rankine_hugoniot) {
  const auto solution = solve_riemann({toro_tests[4].left, toro_tests[4].right, 1.4, 0.3});
  const auto& star = solution.star;
  expect_no_loss_over_front(solution, shock_speed(star.density_left, star.velocity, solution.problem.left));
  expect_no_loss_over_front(solution, shock_speed(star.density_right, star.velocity, solution.problem.right));
}

TEST(Riemann, rarefaction_keeps_entropy_and_its_riemann_invariant) {
  const auto solution = solve_riemann(sod);
  const double t = 0.143, head = 0.5 - std::sqrt(1.4) * t, tail = 0.5 - 0.0702 * t;
  double density = 1;
  for (int k = 1; k < 20; ++k) {
    const GasSample gas = sample(solution, head + (tail - head) * k / 20, t);
    EXPECT_LT(gas.density, density) << "the fan must fall from head to tail";
    density = gas.density;
    EXPECT_NEAR(gas.pressure / std::pow(gas.density, 1.4), 1, 1e-13);
    EXPECT_NEAR(gas.velocity + 5 * std::sqrt(1.4 * gas.pressure / gas.density), 5 * std::sqrt(1.4), 1e-13);
  }
}

TEST(Riemann, rarefaction_joins_its_neighbours_without_a_jump) {
  const auto solution = solve_riemann(sod);
  const double tail = solution.star.velocity - std::sqrt(1.4 * solution.star.pressure / solution.star.density_left);
  for (const double speed : {-std::sqrt(1.4), tail}) {
    const GasSample left = sample(solution, 0.5 + speed - 1e-9, 1), right = sample(solution, 0.5 + speed + 1e-9, 1);
    EXPECT_NEAR(left.density, right.density, 1e-8);
    EXPECT_NEAR(left.velocity, right.velocity, 1e-8);
    EXPECT_NEAR(left.pressure, right.pressure, 1e-8);
  }
}

TEST(Riemann, contact_jumps_in_density_and_energy_only) {
  const auto solution = solve_riemann(sod);
  const double x = 0.5 + solution.star.velocity * 0.1;
  const GasSample left = sample(solution, x - 1e-9, 0.1), right = sample(solution, x + 1e-9, 0.1);
  EXPECT_DOUBLE_EQ(left.pressure, right.pressure);
  EXPECT_DOUBLE_EQ(left.velocity, right.velocity);
  EXPECT_NEAR(left.density, 0.42632, 5e-6);
  EXPECT_NEAR(right.density, 0.26557, 5e-6);
  EXPECT_NEAR(left.specific_energy, 0.30313 / (0.4 * 0.42632), 5e-5);
  EXPECT_NEAR(right.specific_energy, 0.30313 / (0.4 * 0.26557), 5e-5);
}

TEST(Riemann, mirrored_problem_has_the_mirrored_solution) {
  const RiemannProblem problem{{1.3, 0.2, 2}, {0.4, -0.7, 0.3}, 5.0 / 3, 0};
  const RiemannProblem mirror{{0.4, 0.7, 0.3}, {1.3, -0.2, 2}, 5.0 / 3, 0};
  const auto solution = solve_riemann(problem), reflection = solve_riemann(mirror);
  for (double x = -2.03; x < 2.1; x += 0.1) {
    const GasSample a = sample(solution, x, 0.7), b = sample(reflection, -x, 0.7);
    EXPECT_NEAR(a.density, b.density, 1e-13);
    EXPECT_NEAR(a.velocity, -b.velocity, 1e-13);
    EXPECT_NEAR(a.pressure, b.pressure, 1e-13);
    EXPECT_NEAR(a.specific_energy, b.specific_energy, 1e-13);
  }
}

TEST(Riemann, mass_momentum_and_energy_are_conserved) {
  // Over 0 <= x <= 1 at t = 0.143 the waves have not reached the ends: only the pressures there change the momentum.
  const auto solution = solve_riemann(sod);
  const int n = 100000;
  double mass = 0, momentum = 0, energy = 0;
  for (int k = 0; k < n; ++k) {
    const GasSample gas = sample(solution, (k + 0.5) / n, 0.143);
    mass += gas.density / n;
    momentum += gas.density * gas.velocity / n;
    energy += gas.density * (gas.specific_energy + gas.velocity * gas.velocity / 2) / n;
  }
  EXPECT_NEAR(mass, 0.5625, 1e-5);
  EXPECT_NEAR(momentum, 0.9 * 0.143, 1e-5);
  EXPECT_NEAR(energy, 1.375, 1e-5);
}

TEST(Riemann, uniform_gas_stays_uniform) {
  const auto solution = solve_riemann({{2, 3, 5}, {2, 3, 5}, 1.4, 0});
  for (const double x : {-7.0, 0.9, 1.1, 7.0}) {
    const GasSample gas = sample(solution, x, 1);
    EXPECT_NEAR(gas.density, 2, 1e-14);
    EXPECT_NEAR(gas.velocity, 3, 1e-14);
    EXPECT_NEAR(gas.pressure, 5, 1e-14);
    EXPECT_NEAR(gas.specific_energy, 6.25, 1e-13);
  }
}

TEST(Riemann, begins_with_the_two_states) {
  const auto solution = solve_riemann(sod);
  EXPECT_EQ(sample(solution, 0.4999, 0).density, 1);
  EXPECT_EQ(sample(solution, 0.4999, 0).specific_energy, 1 / (1.4 - 1));
  EXPECT_EQ(sample(solution, 0.5, 0).density, 0.125);
  EXPECT_THROW(sample(solution, 0.5, -1e-9), std::domain_error);
  EXPECT_THROW(sample(solution, 0.5, std::nan("")), std::domain_error);
}

TEST(Riemann, two_rarefactions_just_short_of_a_vacuum_are_solved) {
  // Closed form of two rarefactions, Toro (4.46), with z = (gamma - 1)/(2 gamma) = 1/7.
  const double u = 0.999 * 5 * std::sqrt(1.4);
  const StarRegion star = solve_riemann({{1, -u, 1}, {1, u, 1}, 1.4, 0}).star;
  const double expected = std::pow(1 - 0.2 * u / std::sqrt(1.4), 7);
  EXPECT_NEAR(star.pressure, expected, 1e-10 * expected);
  EXPECT_NEAR(star.velocity, 0, 1e-14);
}

TEST(Riemann, refuses_a_vacuum) {
  // With gamma = 5/3 and c = sqrt(gamma p/rho) = 3 the edge is at u = 2 c/(gamma - 1) = 9.
  EXPECT_THROW(solve_riemann({{5, -9.001, 27}, {5, 9.001, 27}, 5.0 / 3, 0}), std::domain_error);
  EXPECT_NO_THROW(solve_riemann({{5, -8.999, 27}, {5, 8.999, 27}, 5.0 / 3, 0}));
  EXPECT_THROW(solve_riemann({{1, -20, 0.4}, {1, 20, 0.4}, 1.4, 0}), std::domain_error);
}

TEST(Riemann, refuses_what_is_no_gas) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const GasState good{1, 0, 1};
  for (const GasState bad : {GasState{0, 0, 1}, GasState{-1, 0, 1}, GasState{1, 0, 0}, GasState{1, 0, -1},
                             GasState{nan, 0, 1}, GasState{1, nan, 1}, GasState{1, 0, nan}, GasState{1, -inf, 1}}) {
    EXPECT_THROW(solve_riemann({bad, good, 1.4, 0}), std::domain_error);
    EXPECT_THROW(solve_riemann({good, bad, 1.4, 0}), std::domain_error);
  }
  for (const double gamma : {1.0, 0.5, nan, inf}) {
    EXPECT_THROW(solve_riemann({good, good, gamma, 0}), std::domain_error);
  }
  EXPECT_THROW(solve_riemann({good, good, 1.4, nan}), std::domain_error);
}

}  // namespace
}  // namespace tether
