// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/bars.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/vec.hpp"
#include "laws/tensors.hpp"

namespace tether {
namespace {

/// One membrane's points in their order.
class MembranePoints {
 public:
  MembranePoints(const Scene& scene, const Body& body)
      : P_(scene.points), body_(body), law_(std::get<Membrane>(body.material)), pinned_(body.count, false) {
    for (const std::size_t p : scene.pinned) {
      if (p >= body.first && p < body.first + body.count) pinned_[p - body.first] = true;
    }
  }

  double distance(std::size_t p, std::size_t q) const { return std::hypot(P_.x[p] - P_.x[q], P_.y[p] - P_.y[q]); }
  std::size_t before(std::size_t p) const {
    return p > body_.first ? p - 1 : body_.closed ? body_.first + body_.count - 1 : p;
  }
  std::size_t behind(std::size_t p) const {
    return p + 1 < body_.first + body_.count ? p + 1 : body_.closed ? body_.first : p;
  }
  /// The end of a curve that is pinned stands for half a piece only, that of a file for a whole one: either has the
  /// section of the point beside it.
  double section(std::size_t p) const {
    const bool end = before(p) == p || behind(p) == p;
    const std::size_t beside = before(p) == p ? behind(p) : before(p);
    return end && pinned_[p - body_.first] && !pinned_[beside - body_.first] ? own_section(beside) : own_section(p);
  }
  /// A stress at the start is a strain at the start, E eps = t . sigma . t: negative is slack.
  double strain(std::size_t p) const {
    const std::size_t a = before(p), b = behind(p);
    const double dx = P_.x[b] - P_.x[a], dy = P_.y[b] - P_.y[a], length = std::hypot(dx, dy);
    const Vec<2> t = length > 0 ? Vec<2>{dx / length, dy / length} : Vec<2>{};
    return along({P_.sxx[p], P_.syy[p], P_.sxy[p]}, t) / law_.E;
  }
  Bar bar(std::size_t a, std::size_t b) const {
    return {a, b, distance(a, b), 0.5 * (section(a) + section(b)), 0.5 * (strain(a) + strain(b)), law_.E, law_.wrinkle};
  }
  Bar bar_to_wall(std::size_t end, std::size_t anchor, double length) const {
    return {end, anchor, length, section(end), strain(end), law_.E, law_.wrinkle};
  }

 private:
  /// Volume over the length of string that the point stands for: half of the way to either neighbour, at an end the
  /// whole way to its only one.
  double own_section(std::size_t p) const {
    const std::size_t a = before(p), b = behind(p);
    const double way = distance(a, p) + distance(p, b);
    return P_.volume[p] / (a == p || b == p ? way : 0.5 * way);
  }

  const PointSet& P_;
  const Body& body_;
  Membrane law_;
  std::vector<bool> pinned_;
};

/// A wall straight on from a string's end.
struct WallAhead {
  const char* name = "";
  Wall wall = Wall::open;
  Held across = holds_none;
  double place = 0;     // of the wall, on the axis across it [length]
  double distance = 0;  // straight on [length]
};

/// The first wall that the line from `inner` through `end` meets less than a spacing beyond the end.
std::optional<WallAhead> wall_ahead(const Scene& scene, std::size_t end, std::size_t inner) {
  const PointSet& P = scene.points;
  const double dx = P.x[end] - P.x[inner], dy = P.y[end] - P.y[inner];
  std::optional<WallAhead> nearest;
  const auto look = [&](const char* name, Wall wall, Held across, double place, double from, double way, double sense) {
    const double spacings = way * sense > 0 ? (place - from) / way : 1;
    if (wall == Wall::open || !(spacings >= 0 && spacings < 1)) return;
    const double distance = spacings * std::hypot(dx, dy);
    if (!nearest || distance < nearest->distance) nearest = WallAhead{name, wall, across, place, distance};
  };
  look("left", scene.walls.left, holds_x, scene.grid.x0, P.x[end], dx, -1);
  look("right", scene.walls.right, holds_x, scene.grid.x1, P.x[end], dx, 1);
  look("bottom", scene.walls.bottom, holds_y, scene.grid.y0, P.y[end], dy, -1);
  look("top", scene.walls.top, holds_y, scene.grid.y1, P.y[end], dy, 1);
  return nearest;
}

/// Returns where the end is joined to: straight on at a fixed wall; at one that holds what is across it, the next
/// place.
Anchor anchor_at(const Scene& scene, std::size_t end, std::size_t inner, const WallAhead& wall) {
  const PointSet& P = scene.points;
  Anchor anchor{end, P.x[end], P.y[end], holds_none};
  if (wall.wall == Wall::fixed) {
    const double part = wall.distance / std::hypot(P.x[end] - P.x[inner], P.y[end] - P.y[inner]);
    anchor.x += part * (P.x[end] - P.x[inner]), anchor.y += part * (P.y[end] - P.y[inner]);
  } else {
    anchor.slides = wall.across == holds_x ? holds_y : holds_x;
  }
  (wall.across == holds_x ? anchor.x : anchor.y) = wall.place;
  return anchor;
}

void meet_wall(const Scene& scene, const MembranePoints& string, std::size_t end, std::size_t inner, BarMesh& mesh) {
  if (mesh.held[end] == (holds_x | holds_y)) return;  // a pin holds it where it is
  const auto wall = wall_ahead(scene, end, inner);
  if (!wall) return;
  const bool slides = wall->wall != Wall::fixed;
  if (wall->distance < held_within * string.distance(end, inner)) {
    mesh.held[end] |= held_by(wall->wall, wall->across);
    mesh.wall_ends.push_back({end, wall->name, 0, slides});
    return;
  }
  const Anchor anchor = anchor_at(scene, end, inner, *wall);
  const double length = std::hypot(anchor.x - scene.points.x[end], anchor.y - scene.points.y[end]);
  mesh.bars.push_back(string.bar_to_wall(end, scene.points.size() + mesh.anchors.size(), length));
  mesh.anchors.push_back(anchor);
  mesh.wall_ends.push_back({end, wall->name, length, slides});
}

void add_string(const Scene& scene, const Body& body, BarMesh& mesh) {
  const MembranePoints string(scene, body);
  const std::size_t first = body.first, last = body.first + body.count - 1;
  for (std::size_t p = first; p < last; ++p) mesh.bars.push_back(string.bar(p, p + 1));
  if (body.closed) return mesh.bars.push_back(string.bar(last, first));
  meet_wall(scene, string, first, first + 1, mesh);
  meet_wall(scene, string, last, last - 1, mesh);
}

}  // namespace

BarMesh bars_of(const Scene& scene) {
  BarMesh mesh;
  mesh.held.assign(scene.points.size(), holds_none);
  for (const std::size_t p : scene.pinned) mesh.held[p] = holds_x | holds_y;
  for (const Body& body : scene.bodies) {
    if (std::holds_alternative<Membrane>(body.material)) add_string(scene, body, mesh);
  }
  return mesh;
}

double highest_frequency(const Scene& scene, const BarMesh& mesh) {
  const std::size_t points = scene.points.size();
  std::vector<double> stiffness(points + mesh.anchors.size(), 0.0);
  // Across a bar its tension over its length acts, which is more than E A / L only where the strain at the start is
  // above 1.
  for (const Bar& bar : mesh.bars) {
    const double k = bar.stiffness() * std::max(1.0, bar.strain);
    stiffness[bar.a] += k, stiffness[bar.b] += k;
  }
  const auto part = [&](std::size_t node) {
    const bool moves = node < points && mesh.held[node] != (holds_x | holds_y);
    return moves ? stiffness[node] / scene.points.mass[node] : 0;
  };
  double squared = 0;
  for (const Bar& bar : mesh.bars) squared = std::max(squared, part(bar.a) + part(bar.b));
  return std::sqrt(squared);
}

namespace {

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
