// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/held_end.hpp"

#include <algorithm>
#include <cmath>

#include "model/bars.hpp"

namespace tether {
namespace {

bool is_pinned(const Scene& scene, std::size_t point) {
  return std::find(scene.pinned.begin(), scene.pinned.end(), point) != scene.pinned.end();
}

std::optional<HeldEnd> end_of_bars(const Scene& scene, std::size_t end) {
  const BarMesh mesh = bars_of(scene);
  for (const Anchor& anchor : mesh.anchors) {
    if (anchor.point == end) return HeldEnd{anchor.x, anchor.y, anchor.slides != holds_none};
  }
  for (const WallEnd& wall : mesh.wall_ends) {
    if (wall.point == end && wall.length == 0) return HeldEnd{scene.points.x[end], scene.points.y[end], wall.slides};
  }
  return std::nullopt;
}

/// The nearest wall ahead of the end in whose row of cells the end is.
std::optional<HeldEnd> end_at_wall(const Scene& scene, std::size_t end, std::size_t inner) {
  const PointSet& P = scene.points;
  const BackgroundGrid& grid = scene.grid;
  const double dx = P.x[end] - P.x[inner], dy = P.y[end] - P.y[inner];
  std::optional<HeldEnd> nearest;
  double nearest_way = 0;
  const auto look = [&](Wall wall, double gap, double cell, double way) {
    if (wall == Wall::open || !(way > 0) || gap < 0 || gap > cell) return;
    const double part = gap / way;
    if (nearest && part >= nearest_way) return;
    nearest = HeldEnd{P.x[end] + part * dx, P.y[end] + part * dy, wall != Wall::fixed};
    nearest_way = part;
  };
  look(scene.walls.left, P.x[end] - grid.x0, grid.dx, -dx);
  look(scene.walls.right, grid.x1 - P.x[end], grid.dx, dx);
  look(scene.walls.bottom, P.y[end] - grid.y0, grid.dy, -dy);
  look(scene.walls.top, grid.y1 - P.y[end], grid.dy, dy);
  return nearest;
}

}  // namespace

std::optional<HeldEnd> held_end(const Scene& scene, const Body& string) {
  const std::size_t end = string.first;
  if (string.closed || string.count < 2) return std::nullopt;
  if (is_pinned(scene, end)) return HeldEnd{scene.points.x[end], scene.points.y[end], false};
  return std::holds_alternative<Bars>(scene.physics) ? end_of_bars(scene, end) : end_at_wall(scene, end, end + 1);
}

}  // namespace tether
