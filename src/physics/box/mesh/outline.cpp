// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/mesh/outline.hpp"

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"

namespace tether::coupled {
namespace {

/// The ends of jets and openings on a side, with its own, ascending.
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

/// The box from its lower left corner up, so that the fluid is to the right.
void add_box(const Coupled& scene, double size, PlaneOutline& outline) {
  std::vector<Vec<3>> places;
  std::vector<Boundary> boundaries;
  for (const int side : {int{side_left}, int{side_top}, int{side_right}, int{side_bottom}}) {
    const std::size_t across = at(axis_of_side(side)), along = 1 - across;
    std::vector<double> ends = ends_on_side(scene, side);
    const bool back = side == side_right || side == side_bottom;
    if (back) std::reverse(ends.begin(), ends.end());
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
      const int parts = std::max(1, static_cast<int>(std::ceil(std::abs(ends[k + 1] - ends[k]) / size - 1e-9)));
      for (int i = 0; i < parts; ++i) {
        Vec<3> place{};
        place[across] = is_low_side(side) ? scene.grid.low[across] : scene.grid.high(static_cast<int>(across));
        place[along] = ends[k] + (ends[k + 1] - ends[k]) * i / parts;
        places.push_back(place), boundaries.push_back({BoundaryKind::box_side, side});
      }
    }
  }
  add_loop(places, boundaries, outline);
}

/// An obstacle from its lower left corner to the right, so that it is to the left.
void add_obstacle(const Box<3>& box, int number, double size, PlaneOutline& outline) {
  const std::array<Vec<3>, 4> corner{Vec<3>{box.low[0], box.low[1], 0}, Vec<3>{box.high[0], box.low[1], 0},
                                     Vec<3>{box.high[0], box.high[1], 0}, Vec<3>{box.low[0], box.high[1], 0}};
  std::vector<Vec<3>> places;
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec<3> way = minus(corner[(k + 1) % 4], corner[k]);
    const int parts = std::max(1, static_cast<int>(std::ceil(std::hypot(way[0], way[1]) / size - 1e-9)));
    for (int i = 0; i < parts; ++i)
      places.push_back({corner[k][0] + way[0] * i / parts, corner[k][1] + way[1] * i / parts, 0});
  }
  add_loop(places, std::vector<Boundary>(places.size(), {BoundaryKind::obstacle, number}), outline);
}

}  // namespace

PlaneOutline plane_outline(const Coupled& scene, const SolidSurface& surface, std::span<const double> q, double size,
                           double away) {
  PlaneOutline outline;
  add_box(scene, size, outline);
  for (std::size_t k = 0; k < scene.obstacles.size(); ++k)
    add_obstacle(scene.obstacles[k], static_cast<int>(k), size, outline);
  std::vector<int> known(q.size() / 2, -1);
  const auto place_of_node = [&](int node) {
    int& place = known[at(node)];
    if (place >= 0) return at(place);
    Vec<3> x = place_of(q, node, 2);
    for (std::size_t a = 0; a < 2; ++a)
      x[a] = std::clamp(x[a], scene.grid.low[a] + away, scene.grid.high(static_cast<int>(a)) - away);
    place = static_cast<int>(outline.places.size());
    outline.places.push_back(x);
    return at(place);
  };
  for (std::size_t s = 0; s < surface.side_count(); ++s) {
    const auto nodes = surface.side(s);
    outline.segments.push_back(
        {{place_of_node(nodes[0]), place_of_node(nodes[1])}, {BoundaryKind::solid, static_cast<int>(s)}});
  }
  return outline;
}

}  // namespace tether::coupled
