// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/riemann_tube.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <utility>

namespace tether {
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

/// Where a small wave is that left `x` at the time `begin`: dx/dt = u + a in the solution, by the mid-point rule.
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

/// Whether gas of a body comes in or goes out as if the tube went on: an outflow with nothing outside, or the body's
/// own state outside.
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
