// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/mesh/outline.hpp"

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"

namespace tether::coupled {
namespace {

/// The ends of jets, openings and obstacles along a side, with its own, ascending.
std::vector<double> ends_on_side(const Coupled& scene, int side) {
  const std::size_t along = axis_of_side(side) == 0 ? 1 : 0;
  const double low = scene.grid.low[along], high = scene.grid.high(static_cast<int>(along));
  std::vector<double> ends{low, high};
  const auto add = [&](int of_side, const Box<3>& patch) {
    if (of_side != side) return;
    for (const double end : {patch.low[along], patch.high[along]}) ends.push_back(std::clamp(end, low, high));
  };
  for (const Jet& jet : scene.jets) add(jet.side, jet.patch);
  for (const Opening& opening : scene.openings) add(opening.side, opening.patch);
  for (const Box<3>& obstacle : scene.obstacles) add(side, obstacle);
  std::sort(ends.begin(), ends.end());
  const double least = 1e-9 * (high - low);
  ends.erase(std::unique(ends.begin(), ends.end(), [&](double a, double b) { return b - a <= least; }), ends.end());
  ends.back() = high;
  return ends;
}

/// Adds segments from place to place, and from the last to the first one.
void add_loop(std::span<const Vec<3>> places, std::span<const Boundary> boundaries, PlaneOutline& outline) {
  const std::size_t first = outline.places.size(), count = places.size();
  for (std::size_t k = 0; k < count; ++k) {
    outline.places.push_back(places[k]);
    outline.segments.push_back({{first + k, first + (k + 1) % count}, boundaries[k]});
  }
}

/// Adds places from one end to the next along a line across an axis, no farther apart than `size`, but the last end.
void add_places(std::size_t across, double level, std::span<const double> ends, double size,
                std::vector<Vec<3>>& places) {
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    const int parts = std::max(1, static_cast<int>(std::ceil(std::abs(ends[k + 1] - ends[k]) / size - 1e-9)));
    for (int i = 0; i < parts; ++i) {
      Vec<3> place{};
      place[across] = level, place[1 - across] = ends[k] + (ends[k + 1] - ends[k]) * i / parts;
      places.push_back(place);
    }
  }
}

/// The box from its lower left corner up, so that the fluid is to the right.
void add_box(const Coupled& scene, double size, PlaneOutline& outline) {
  std::vector<Vec<3>> places;
  std::vector<Boundary> boundaries;
  for (const int side : {int{side_left}, int{side_top}, int{side_right}, int{side_bottom}}) {
    const std::size_t across = at(axis_of_side(side));
    std::vector<double> ends = ends_on_side(scene, side);
    const bool back = side == side_right || side == side_bottom;
    if (back) std::reverse(ends.begin(), ends.end());
    add_places(across, is_low_side(side) ? scene.grid.low[across] : scene.grid.high(static_cast<int>(across)), ends,
               size, places);
    boundaries.resize(places.size(), {BoundaryKind::box_side, side});
  }
  add_loop(places, boundaries, outline);
}

/// Obstacle `number` as far as it lies in the box, from its lower left corner to the right, so that it is to the left.
/// Its sides end where those of others cross them.
void add_obstacle(const Coupled& scene, std::size_t number, double size, PlaneOutline& outline) {
  const auto within = [&](const Box<3>& box, std::size_t a) {
    const double low = scene.grid.low[a], high = scene.grid.high(static_cast<int>(a));
    return std::array{std::clamp(box.low[a], low, high), std::clamp(box.high[a], low, high)};
  };
  const auto x = within(scene.obstacles[number], 0), y = within(scene.obstacles[number], 1);
  if (x[0] == x[1] || y[0] == y[1]) return;
  const auto cuts = [&](std::size_t a, double from, double to) {
    std::vector<double> places{from, to};
    for (const Box<3>& other : scene.obstacles) {
      for (const double place : within(other, a)) places.push_back(std::clamp(place, from, to));
    }
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    return places;
  };
  std::vector<Vec<3>> places;
  for (const int side : {int{side_bottom}, int{side_right}, int{side_top}, int{side_left}}) {
    const std::size_t across = at(axis_of_side(side));
    std::vector<double> ends = across == 1 ? cuts(0, x[0], x[1]) : cuts(1, y[0], y[1]);
    if (side == side_top || side == side_left) std::reverse(ends.begin(), ends.end());
    add_places(across, (across == 0 ? x : y)[is_low_side(side) ? 0 : 1], ends, size, places);
  }
  add_loop(places, std::vector<Boundary>(places.size(), {BoundaryKind::obstacle, static_cast<int>(number)}), outline);
}

/// Keeps a place off the sides that stop bodies.
Vec<3> held_off(const Coupled& scene, Vec<3> x, double away) {
  for (int side = 0; side < 4; ++side) {
    if (!is_wall(scene.sides[at(side)])) continue;
    double& along = x[at(axis_of_side(side))];
    along = is_low_side(side) ? std::max(along, scene.grid.low[at(axis_of_side(side))] + away)
                              : std::min(along, scene.grid.high(axis_of_side(side)) - away);
  }
  return x;
}

/// From where to where a segment lies in the box, from 0 to 1.
std::array<double, 2> part_in_box(const Coupled& scene, const std::array<Vec<3>, 2>& ends) {
  std::array<double, 2> part{0, 1};
  for (int side = 0; side < 4; ++side) {
    const std::size_t a = at(axis_of_side(side));
    const double edge = is_low_side(side) ? scene.grid.low[a] : scene.grid.high(static_cast<int>(a)),
                 sign = is_low_side(side) ? 1 : -1, first = sign * (ends[0][a] - edge),
                 last = sign * (ends[1][a] - edge);
    if (first < 0 && last <= 0) return {1, 0};
    if (first <= 0 && last < 0) return {1, 0};
    if (first < 0) part[0] = std::max(part[0], first / (first - last));
    if (last < 0) part[1] = std::min(part[1], first / (first - last));
  }
  return part;
}

/// Returns the place at a part of a segment, to the last bit on the side of the box that it meets there.
Vec<3> place_on_side(const Coupled& scene, const std::array<Vec<3>, 2>& ends, double part) {
  Vec<3> x{};
  for (std::size_t a = 0; a < 2; ++a) {
    x[a] = ends[0][a] + part * (ends[1][a] - ends[0][a]);
    const double low = scene.grid.low[a], high = scene.grid.high(static_cast<int>(a)), near = 1e-12 * (high - low);
    if (x[a] < low + near) x[a] = low;
    if (x[a] > high - near) x[a] = high;
  }
  return x;
}

}  // namespace

PlaneOutline plane_outline(const Coupled& scene, const SolidSurface& surface, std::span<const double> q, double size,
                           double away) {
  PlaneOutline outline;
  add_box(scene, size, outline);
  for (std::size_t k = 0; k < scene.obstacles.size(); ++k) add_obstacle(scene, k, size, outline);
  std::vector<int> known(q.size() / 2, -1);
  const auto place_of_node = [&](int node, const Vec<3>& x) {
    int& place = known[at(node)];
    if (place < 0) place = static_cast<int>(outline.places.size()), outline.places.push_back(x);
    return at(place);
  };
  for (std::size_t s = 0; s < surface.side_count(); ++s) {
    const auto nodes = surface.side(s);
    const std::array<Vec<3>, 2> ends{held_off(scene, place_of(q, nodes[0], 2), away),
                                     held_off(scene, place_of(q, nodes[1], 2), away)};
    const auto part = part_in_box(scene, ends);
    if (part[0] >= part[1]) continue;
    std::array<std::size_t, 2> places{};
    for (std::size_t e = 0; e < 2; ++e) {
      if (part[e] == static_cast<double>(e)) {
        places[e] = place_of_node(nodes[e], ends[e]);
      } else {
        places[e] = outline.places.size();
        outline.places.push_back(place_on_side(scene, ends, part[e]));
      }
    }
    outline.segments.push_back({places, {BoundaryKind::solid, static_cast<int>(s)}});
  }
  return outline;
}

}  // namespace tether::coupled
