// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/mpm/leak_watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "loops/points.hpp"

namespace tether::mpm {
namespace {

/// The edge of the grid at which a membrane ends, left, right, bottom, top; -1 where there is none within half a cell
/// of its end, which lies half a piece beyond its last point.
int side_at(const BackgroundGrid& grid, const Vec2& at, const Vec2& before) {
  const double half_a_piece = 0.5 * std::hypot((at.x - before.x) / grid.dx, (at.y - before.y) / grid.dy);
  const double cells[] = {(at.x - grid.x0) / grid.dx, (grid.x1 - at.x) / grid.dx, (at.y - grid.y0) / grid.dy,
                          (grid.y1 - at.y) / grid.dy};
  const auto nearest = std::min_element(std::begin(cells), std::end(cells));
  return *nearest <= 0.5 + half_a_piece ? static_cast<int>(nearest - std::begin(cells)) : -1;
}

/// Whether a ray from the place to the right crosses the closed outline an odd number of times.
bool is_inside(const std::vector<Vec2>& outline, const Vec2& at) {
  bool inside = false;
  for (std::size_t k = 0, before = outline.size() - 1; k < outline.size(); before = k++) {
    const Vec2 &a = outline[before], &b = outline[k];
    if ((a.y > at.y) != (b.y > at.y) && at.x < a.x + (at.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return inside;
}

/// Distance of a place from the piece between two others.
double distance(const Vec2& a, const Vec2& b, const Vec2& at) {
  const double x = b.x - a.x, y = b.y - a.y, squared = x * x + y * y;
  const double part = squared > 0 ? std::clamp(((at.x - a.x) * x + (at.y - a.y) * y) / squared, 0.0, 1.0) : 0;
  return std::hypot(at.x - a.x - part * x, at.y - a.y - part * y);
}

}  // namespace

LeakWatch::LeakWatch(const Scene& scene) : deep_(0.5 * std::min(scene.grid.dx, scene.grid.dy)) {
  if (!find_body<IdealGas>(scene)) return;
  const PointSet& P = scene.points;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const Body& body = scene.bodies[b];
    if (!std::holds_alternative<Membrane>(body.material) || body.count < 3) continue;
    Outline points;
    for_points({body.first, body.first + body.count}, [&](std::size_t p) { points.push_back({P.x[p], P.y[p]}); });
    Parting parting{b, -1, -1, {}};
    if (!body.closed) {
      parting.first_side = side_at(scene.grid, points.front(), points[1]);
      parting.last_side = side_at(scene.grid, points.back(), points[points.size() - 2]);
      if (parting.first_side < 0 || parting.last_side < 0) continue;
    }
    const Outline around = outline(parting, scene.grid, std::move(points));
    for_points({0, P.size()}, [&](std::size_t p) {
      parting.inside.push_back(is_inside(around, {P.x[p], P.y[p]}) ? 1 : 0);
    });
    walls_.push_back(std::move(parting));
  }
}

/// Closes the membrane along edges of the grid, far enough off that no point lies beyond.
LeakWatch::Outline LeakWatch::outline(const Parting& parting, const BackgroundGrid& grid, Outline points) {
  const int first = parting.first_side, last = parting.last_side;
  if (first == last) return points;
  const double far = (grid.x1 - grid.x0) + (grid.y1 - grid.y0);
  const auto beyond = [&](int side, Vec2 at) {
    if (side == 0) at.x = grid.x0 - far;
    if (side == 1) at.x = grid.x1 + far;
    if (side == 2) at.y = grid.y0 - far;
    if (side == 3) at.y = grid.y1 + far;
    return at;
  };
  const bool across = (first < 2) == (last < 2);  // from an edge to the opposite one
  const int round = first < 2 ? 3 : 1;
  const Vec2 start = beyond(first, points.front()), end = beyond(last, points.back());
  points.push_back(end);
  points.push_back(across ? beyond(round, end) : beyond(first, end));
  if (across) points.push_back(beyond(round, start));
  points.push_back(start);
  return points;
}

std::size_t LeakWatch::passed(const Parting& parting, const State& state, const Scene& scene) const {
  const Points& P = state.points;
  Outline points;
  for_points(state.ranges[parting.body], [&](std::size_t p) { points.push_back({P.x[p], P.y[p]}); });
  const std::size_t pieces = points.size() - (scene.bodies[parting.body].closed ? 0 : 1), count = points.size();
  const Outline around = outline(parting, scene.grid, std::move(points));
  std::size_t passed = 0;
  for (const Range range : state.gas) {
    for_points(range, [&](std::size_t p) {
      const auto number = static_cast<std::size_t>(P.id[p]);
      const Vec2 at{P.x[p], P.y[p]};
      if (number >= parting.inside.size() || is_inside(around, at) == (parting.inside[number] != 0)) return;
      double nearest = 2 * deep_;
      for (std::size_t k = 0; k < pieces; ++k)
        nearest = std::min(nearest, distance(around[k], around[(k + 1) % count], at));
      passed += nearest > deep_;
    });
  }
  return passed;
}

void LeakWatch::look(State& state, const Scene& scene, std::vector<std::string>& messages) const {
  std::size_t all = 0;
  for (const Parting& parting : walls_) {
    const std::size_t here = passed(parting, state, scene);
    all += here;
    if (here == 0 || state.leak_told) continue;
    state.leak_told = true;
    messages.push_back(fmt::format(
        "t = {:.6g}: body {}, {}: gas seeps through it: points of gas half a cell and more beyond the side that they "
        "began on: {}: use more points and smaller cells, or method='robust' of $mpm",
        state.time, parting.body + 1, scene.bodies[parting.body].name, here));
  }
  state.gas_leaked = static_cast<long long>(all);
}

}  // namespace tether::mpm
