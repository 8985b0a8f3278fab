// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/riemann.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
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

/// Returns the same state seen in a mirror at x = 0: a wave to the right becomes one to the left.
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

namespace {

constexpr double never = std::numeric_limits<double>::infinity();
/// Steps along a characteristic.
constexpr int characteristic_steps = 4000;

/// When the end at the left of a solution begins to send waves.
double begin_at_left(const RiemannSolution& solution, const TubeEnd& end) {
  if (end.kind == EndKind::vacuum) return 0;
  if (end.kind == EndKind::wall && solution.problem.left.velocity != 0) return 0;
  const double speed = left_wave_speed(solution);
  return speed < 0 ? (end.x - solution.problem.diaphragm) / speed : never;
}

/// Returns where a small wave is that left `x` at the time `begin`: dx/dt = u + a in the solution, by the mid-point
/// rule.
double along_characteristic(const RiemannSolution& solution, double x, double begin, double t) {
  const auto speed = [&](double at, double time) {
    const GasSample gas = sample(solution, at, time);
    const double gamma = solution.problem.gamma;
    return gas.velocity + std::sqrt(gamma * (gamma - 1) * gas.specific_energy);
  };
  const double dt = (t - begin) / characteristic_steps;
  for (int k = 0; k < characteristic_steps; ++k) {
    const double time = begin + k * dt;
    x += dt * speed(x + dt / 2 * speed(x, time), time + dt / 2);
  }
  return x;
}

/// The gas that a shock from a wall runs into, and the speed of what is ahead of that.
struct Ahead {
  GasState gas;
  double next_wave = 0;
};

Ahead ahead_of_wall(const RiemannSolution& solution, double begin) {
  const StarRegion& star = solution.star;
  if (begin == 0) return {solution.problem.left, left_wave_speed(solution)};
  const bool shock = star.pressure > solution.problem.left.pressure;
  if (shock) return {{star.density_left, star.velocity, star.pressure}, star.velocity};
  return {{}, 0};  // a rarefaction is sent back as one
}

/// How far into the tube the waves of its left end have come.
double reach_of_left(const RiemannSolution& solution, const TubeEnd& end, double t) {
  const double begin = begin_at_left(solution, end);
  if (!(t > begin)) return end.x;
  const Ahead ahead = ahead_of_wall(solution, begin);
  if (end.kind != EndKind::wall || !(ahead.gas.velocity < 0))
    return std::max(end.x, along_characteristic(solution, end.x, begin, t));
  const double x = end.x + speed_of_shock_from_wall(ahead.gas, solution.problem.gamma) * (t - begin);
  return x < solution.problem.diaphragm + ahead.next_wave * t ? x : never;
}

TubeEnd mirrored(const TubeEnd& end) { return {-end.x, end.kind}; }

GasState state_of(const Scene& scene, const Body& body) {
  const auto& gas = std::get<IdealGas>(body.material);
  return {body.density, scene.points.vx[body.first], gas.pressure(body.density, body.specific_energy)};
}

/// First and last column of a body's points, and half of what is between two columns.
struct Columns {
  double low = 0, high = 0, half = 0;

  Columns(const Scene& scene, const Body& body) {
    std::set<double> x;
    for (std::size_t p = body.first; p < body.first + body.count; ++p) x.insert(scene.points.x[p]);
    low = *x.begin(), high = *x.rbegin();
    if (x.size() > 1) half = (high - low) / static_cast<double>(x.size() - 1) / 2;
  }
};

/// Returns whether gas of a body comes in or goes out as if the tube went on: an outflow with nothing outside, or the
/// body's own state outside.
bool goes_on(const Scene& scene, const Edge& edge, const Body& body) {
  if (edge.kind == EdgeKind::outflow && !edge.has_outside) return true;
  const bool same = edge.density == body.density && edge.energy == body.specific_energy;
  return same && (edge.kind == EdgeKind::outflow || edge.u == scene.points.vx[body.first]);
}

/// Gas that ends within a cell of a wall stands at it, or at an open edge. Where that has another state outside, waves
/// run in at once, as from where gas ends.
TubeEnd end_of(const Scene& scene, std::size_t side, const Body& body, double gas_x) {
  const double wall_x = side == 0 ? scene.grid.x0 : scene.grid.x1, cell = scene.grid.dx;
  const Edge& edge = scene.edges.of[side];
  if (edge.open() && std::abs(wall_x - gas_x) < cell)
    return {wall_x, goes_on(scene, edge, body) ? EndKind::edge : EndKind::vacuum};
  const Wall wall = side == 0 ? scene.walls.left : scene.walls.right;
  const bool at_wall = wall != Wall::open && std::abs(wall_x - gas_x) < cell;
  return {at_wall ? wall_x : gas_x, at_wall ? EndKind::wall : EndKind::vacuum};
}

}  // namespace

double RiemannTube::left_begins() const { return begin_at_left(solution, left); }
double RiemannTube::right_begins() const { return begin_at_left(mirror_image(solution), mirrored(right)); }

TubePart RiemannTube::valid_part(double t) const {
  return {reach_of_left(solution, left, t), -reach_of_left(mirror_image(solution), mirrored(right), t)};
}

RiemannTube riemann_tube(const Scene& scene) {
  const Body* left = &scene.bodies[0];
  const Body* right = &scene.bodies[1];
  if (Columns(scene, *left).low > Columns(scene, *right).low) std::swap(left, right);
  const Columns of_left(scene, *left), of_right(scene, *right);
  const double diaphragm = 0.5 * (of_left.high + of_right.low);
  return {solve_riemann(
              {state_of(scene, *left), state_of(scene, *right), std::get<IdealGas>(left->material).gm1 + 1, diaphragm}),
          end_of(scene, 0, *left, of_left.low - of_left.half), end_of(scene, 1, *right, of_right.high + of_right.half)};
}

TubePart compared_part(const Scene& scene, const RiemannTube& tube, double t) {
  const TubePart valid = tube.valid_part(t);
  if (valid.empty()) {
    throw std::domain_error(
        fmt::format("at t = {:.4g} waves from the ends are everywhere in the tube; the first left an end at t = {:.4g}",
                    t, std::min(tube.left_begins(), tube.right_begins())));
  }
  if (!scene.reference_window) return valid;
  const auto [from, to] = *scene.reference_window;
  const double slip = 1e-9 * (scene.grid.x1 - scene.grid.x0);
  if (from < valid.from - slip || to > valid.to + slip) {
    throw std::domain_error(fmt::format(
        "at t = {:.4g} the exact solution holds from x = {:.4g} to {:.4g} alone, as waves come from the ends of the "
        "tube; the window goes from {:.4g} to {:.4g}",
        t, valid.from, valid.to, from, to));
  }
  return {from, to};
}

}  // namespace tether
