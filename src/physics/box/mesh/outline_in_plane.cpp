// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/mesh/outline.hpp"

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "physics/box/flow_box.hpp"

namespace tether::coupled {
namespace {

/// The ends of jets and openings along a side, with its own, ascending.
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

/// Adds a segment in equal parts no longer than `size`.
void add_segment(std::size_t from, std::size_t to, const Boundary& boundary, bool has_fluid, double size,
                 Outline& outline) {
  const Vec<3> a = outline.places[from], way = minus(outline.places[to], a);
  const int parts = std::max(1, static_cast<int>(std::ceil(std::sqrt(dot(way, way)) / size - 1e-9)));
  std::size_t last = from;
  for (int k = 1; k <= parts; ++k) {
    std::size_t next = to;
    if (k < parts) {
      next = outline.places.size();
      const double part = static_cast<double>(k) / parts;
      outline.places.push_back({a[0] + part * way[0], a[1] + part * way[1], 0});
    }
    outline.facets.push_back({{last, next, 0}, boundary, 0, has_fluid});
    last = next;
  }
}

/// The sides of the box from its lower left corner up, so that the fluid is to the right.
void add_box(const Coupled& scene, Outline& outline) {
  for (const int side : {int{side_left}, int{side_top}, int{side_right}, int{side_bottom}}) {
    const std::size_t across = at(axis_of_side(side));
    std::vector<double> ends = ends_on_side(scene, side);
    if (side == side_right || side == side_bottom) std::reverse(ends.begin(), ends.end());
    const auto place = [&](double end) {
      Vec<3> x{};
      x[across] = is_low_side(side) ? scene.grid.low[across] : scene.grid.high(static_cast<int>(across));
      x[1 - across] = end;
      return x;
    };
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
      const Vec<3> from = place(ends[k]), to = place(ends[k + 1]);
      const Vec<3> middle{0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1]), 0};
      outline.places.push_back(from), outline.places.push_back(to);
      add_segment(outline.places.size() - 2, outline.places.size() - 1, {BoundaryKind::box_side, side}, true,
                  jet_at(scene, side, middle) < 0 ? scene.mesh->size : scene.mesh->near, outline);
    }
  }
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

Outline outline_in_plane(const Coupled& scene, const FlowSurface& surface, std::span<const double> q, double gap) {
  Outline outline;
  if (!scene.cavities_only) add_box(scene, outline);
  const std::vector<double> places = surface.places_apart(q, gap);
  std::vector<int> known(places.size() / 2, -1);
  const auto place_of_node = [&](int node, const Vec<3>& x) {
    int& place = known[at(node)];
    if (place < 0) place = static_cast<int>(outline.places.size()), outline.places.push_back(x);
    return at(place);
  };
  for (std::size_t s = 0; s < surface.all().side_count(); ++s) {
    const auto nodes = surface.all().side(s);
    const std::array<Vec<3>, 2> ends{place_of(places, nodes[0], 2), place_of(places, nodes[1], 2)};
    outline.around.push_back(ends);
    const auto part = scene.cavities_only ? std::array{0.0, 1.0} : part_in_box(scene, ends);
    if (part[0] >= part[1]) continue;
    std::array<std::size_t, 2> of{};
    for (std::size_t e = 0; e < 2; ++e) {
      if (part[e] == static_cast<double>(e)) {
        of[e] = place_of_node(nodes[e], ends[e]);
      } else {
        of[e] = outline.places.size();
        outline.places.push_back(place_on_side(scene, ends, part[e]));
      }
    }
    const bool cavity = surface.all().cavity[at(surface.all().sheet[s])] != 0;
    add_segment(of[0], of[1], {surface.is_body(s) ? BoundaryKind::solid : BoundaryKind::obstacle, static_cast<int>(s)},
                !scene.cavities_only || cavity, scene.mesh->near, outline);
  }
  return outline;
}

}  // namespace tether::coupled
