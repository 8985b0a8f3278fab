// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/riemann.hpp"

#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>

namespace tether {
namespace {

double sound_speed(const GasState& state, double gamma) { return std::sqrt(gamma * state.pressure / state.density); }

/// Change of velocity across the wave that takes `state` to pressure p: Toro (4.6), (4.7).
double velocity_change(const GasState& state, double p, double gamma) {
  if (p > state.pressure) {
    const double a = 2 / ((gamma + 1) * state.density);           // (4.8)
    const double b = (gamma - 1) / (gamma + 1) * state.pressure;  // (4.8)
    return (p - state.pressure) * std::sqrt(a / (p + b));
  }
  const double ratio = std::pow(p / state.pressure, (gamma - 1) / (2 * gamma));
  return 2 * sound_speed(state, gamma) / (gamma - 1) * (ratio - 1);
}

/// Density behind the wave that takes `state` to pressure p: Toro (4.50) for a shock, (4.53) for a rarefaction.
double density_behind(const GasState& state, double p, double gamma) {
  const double ratio = p / state.pressure;
  if (ratio <= 1) return state.density * std::pow(ratio, 1 / gamma);
  const double g = (gamma - 1) / (gamma + 1);
  return state.density * (ratio + g) / (g * ratio + 1);
}

bool is_gas(const GasState& state) {
  return std::isfinite(state.density) && std::isfinite(state.velocity) && std::isfinite(state.pressure) &&
         state.density > 0 && state.pressure > 0;
}

void check(const RiemannProblem& problem) {
  if (!is_gas(problem.left) || !is_gas(problem.right)) {
    throw std::domain_error("Riemann problem: density and pressure must be positive, all numbers finite");
  }
  if (!std::isfinite(problem.gamma) || problem.gamma <= 1 || !std::isfinite(problem.diaphragm)) {
    throw std::domain_error("Riemann problem: gamma must be above 1 and the diaphragm at a finite place");
  }
  const double opening = problem.right.velocity - problem.left.velocity;
  const double closing = sound_speed(problem.left, problem.gamma) + sound_speed(problem.right, problem.gamma);
  if (opening >= 2 * closing / (problem.gamma - 1)) {  // (4.40)
    throw std::domain_error("Riemann problem: a vacuum opens between the two states");
  }
}

/// The root of a mismatch that rises with p and is negative at p = 0; it is looked for from `above` on.
template <class Mismatch>
double pressure_root(const Mismatch& mismatch, double above) {
  while (mismatch(above) < 0) above *= 2;
  std::uintmax_t steps = 1000;
  const boost::math::tools::eps_tolerance<double> full(std::numeric_limits<double>::digits - 2);
  const auto [low, high] = boost::math::tools::toms748_solve(mismatch, 0.0, above, full, steps);
  return (low + high) / 2;
}

/// The root of Toro (4.5), negative at p = 0 where no vacuum opens.
double star_pressure(const RiemannProblem& problem) {
  const auto mismatch = [&problem](double p) {
    return velocity_change(problem.left, p, problem.gamma) + velocity_change(problem.right, p, problem.gamma) +
           problem.right.velocity - problem.left.velocity;
  };
  return pressure_root(mismatch, std::fmax(problem.left.pressure, problem.right.pressure));
}

/// Inside the fan of a left rarefaction, where x/t = speed: Toro (4.56).
GasState inside_fan(const GasState& left, double speed, double gamma) {
  const double a = sound_speed(left, gamma);
  const double ratio = 2 / (gamma + 1) + (gamma - 1) / ((gamma + 1) * a) * (left.velocity - speed);
  return {left.density * std::pow(ratio, 2 / (gamma - 1)),
          2 / (gamma + 1) * (a + (gamma - 1) / 2 * left.velocity + speed),
          left.pressure * std::pow(ratio, 2 * gamma / (gamma - 1))};
}

/// Speed of a shock over that of sound in the gas ahead of it: Toro (4.52).
double mach_number(double pressure_ratio, double gamma) {
  return std::sqrt((gamma + 1) / (2 * gamma) * pressure_ratio + (gamma - 1) / (2 * gamma));
}

/// Left of the contact, on the ray x/t = speed, with the left outer state and its star state: Toro 4.5.1.
GasState left_of_contact(const GasState& left, const GasState& star, double speed, double gamma) {
  const double a = sound_speed(left, gamma);
  if (star.pressure > left.pressure) {
    const double mach = mach_number(star.pressure / left.pressure, gamma);
    return speed < left.velocity - a * mach ? left : star;  // (4.52)
  }
  if (speed < left.velocity - a) return left;                          // head, (4.55)
  if (speed >= star.velocity - sound_speed(star, gamma)) return star;  // tail, (4.55)
  return inside_fan(left, speed, gamma);
}

/// The same state seen in a mirror at x = 0: a wave to the right becomes one to the left.
GasState mirrored(const GasState& state) { return {state.density, -state.velocity, state.pressure}; }

GasState on_ray(const RiemannSolution& solution, double speed) {
  const auto& [problem, star] = solution;
  if (speed < star.velocity) {
    return left_of_contact(problem.left, {star.density_left, star.velocity, star.pressure}, speed, problem.gamma);
  }
  const GasState star_right{star.density_right, star.velocity, star.pressure};
  return mirrored(left_of_contact(mirrored(problem.right), mirrored(star_right), -speed, problem.gamma));
}

}  // namespace

RiemannSolution solve_riemann(const RiemannProblem& problem) {
  check(problem);
  const auto& [left, right, gamma, diaphragm] = problem;
  const double p = star_pressure(problem);
  const double velocity = (left.velocity + right.velocity) / 2 +
                          (velocity_change(right, p, gamma) - velocity_change(left, p, gamma)) / 2;  // (4.9)
  return {problem, {p, velocity, density_behind(left, p, gamma), density_behind(right, p, gamma)}};
}

double left_wave_speed(const RiemannSolution& solution) {
  const GasState& left = solution.problem.left;
  const double gamma = solution.problem.gamma, ratio = solution.star.pressure / left.pressure;
  return left.velocity - sound_speed(left, gamma) * (ratio > 1 ? mach_number(ratio, gamma) : 1);
}

RiemannSolution mirror_image(const RiemannSolution& solution) {
  const auto& [problem, star] = solution;
  return {{mirrored(problem.right), mirrored(problem.left), problem.gamma, -problem.diaphragm},
          {star.pressure, -star.velocity, star.density_right, star.density_left}};
}

double speed_of_shock_from_wall(const GasState& gas, double gamma) {
  const double a = sound_speed(gas, gamma);
  if (gas.velocity >= 0) return gas.velocity + a;
  const auto mismatch = [&](double p) { return velocity_change(gas, p, gamma) + gas.velocity; };
  return gas.velocity + a * mach_number(pressure_root(mismatch, gas.pressure) / gas.pressure, gamma);
}

GasSample sample(const RiemannSolution& solution, double x, double t) {
  if (!(t >= 0)) throw std::domain_error("Riemann problem: the solution begins at t = 0");
  const auto& problem = solution.problem;
  const double distance = x - problem.diaphragm;
  const GasState initial = distance < 0 ? problem.left : problem.right;
  const GasState state = t > 0 ? on_ray(solution, distance / t) : initial;
  const double specific_energy = state.pressure / ((problem.gamma - 1) * state.density);
  return {state.density, state.velocity, state.pressure, specific_energy};
}

}  // namespace tether
