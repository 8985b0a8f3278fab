// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/mesh/flow_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/numbers.hpp"
#include "grid/box_tree.hpp"
#include "physics/box/mesh/facet_distance.hpp"
#include "physics/box/obstacles.hpp"

namespace tether::coupled {
namespace {

constexpr double curve = 16;  // sizes of the mesh, of whose thousandth a curved obstacle and its sides are apart

Box<3> box_of(const SolidSurface& surface, std::size_t side, std::span<const double> q) {
  constexpr double far = std::numeric_limits<double>::max();
  Box<3> box{{far, far, far}, {-far, -far, -far}};
  for (const int n : surface.side(side)) box.add(place_of(q, n, surface.dim));
  return box;
}

/// The distance of a place from a side, above 0 out of its solid.
double distance_from(const SolidSurface& surface, std::size_t side, std::span<const double> q, const Vec<3>& x) {
  std::array<Vec<3>, 3> corners{};
  std::ranges::transform(surface.side(side), corners.begin(), [&](int n) { return place_of(q, n, surface.dim); });
  const double out = dot(area_of_side(surface, side, q), minus(x, corners[0]));
  return std::copysign(facet_distance(surface.dim, corners, x), out);
}

}  // namespace

FlowSurface::FlowSurface(const Coupled& scene, const SolidSurface& bodies, std::size_t places)
    : scene_(scene), all_(bodies), body_sides_(bodies.side_count()), body_nodes_(places / at(bodies.dim)) {
  const double size = scene.mesh->near;
  const auto add = [&](const Figure& figure) {
    add_figure(surface_of(figure, scene.grid.dim, scene.grid.box(), curve * size), places, fixed_, all_);
  };
  for (const Box<3>& obstacle : scene.obstacles) add(obstacle);
  brick_sides_ = all_.side_count();
  for (const Obstacle& obstacle : scene.shaped) add(obstacle.figure);
  part_of_node_.assign(body_nodes_ + fixed_.size() / at(all_.dim), -1);
  for (std::size_t s = 0; s < all_.side_count(); ++s) {
    for (const int n : all_.side(s)) part_of_node_[at(n)] = all_.part[s];
  }
}

/// Out of the solids at each node, of length 1.
std::vector<Vec<3>> FlowSurface::normals(std::span<const double> q) const {
  std::vector<Vec<3>> normals(part_of_node_.size());
  for (std::size_t s = 0; s < all_.side_count(); ++s) {
    const Vec<3> area = area_of_side(all_, s, q);
    const double size = std::sqrt(dot(area, area));
    if (size == 0) continue;
    for (const int n : all_.side(s)) {
      for (std::size_t a = 0; a < 3; ++a) normals[at(n)][a] += area[a] / size;
    }
  }
  for (Vec<3>& normal : normals) {
    const double size = std::sqrt(dot(normal, normal));
    if (size > 0) normal = {normal[0] / size, normal[1] / size, normal[2] / size};
  }
  return normals;
}

std::vector<double> FlowSurface::places_apart(std::span<const double> q, double gap) const {
  std::vector<double> places(q.begin(), q.end());
  places.insert(places.end(), fixed_.begin(), fixed_.end());
  if (body_sides_ == 0) return places;
  const std::vector<Vec<3>> normal = normals(places);
  std::vector<Box<3>> boxes;
  for (std::size_t s = 0; s < all_.side_count(); ++s) boxes.push_back(box_of(all_, s, places));
  const BoxTree tree(boxes);
  std::vector<double> back(normal.size(), 0.0);  // of each node, along its normal
  for (std::size_t n = 0; n < normal.size(); ++n) {
    if (part_of_node_[n] < 0) continue;
    const Vec<3> x = place_of(places, static_cast<int>(n), all_.dim);
    for (const int side : tree.meeting({x, x}, gap)) hold_apart(n, at(side), x, gap, places, normal, back);
  }
  for (std::size_t n = 0; n < body_nodes_; ++n) {
    for (std::size_t a = 0; a < at(all_.dim); ++a) places[n * at(all_.dim) + a] -= back[n] * normal[n][a];
  }
  if (!scene_.cavities_only) hold_off_walls(places, gap);
  return places;
}

/// Notes how far a node, or where it is one of an obstacle the nodes of a side of a body, must go back for a gap. Of
/// one body only sides across a room from the node count.
void FlowSurface::hold_apart(std::size_t node, std::size_t side, const Vec<3>& x, double gap, std::span<const double> q,
                             std::span<const Vec<3>> normal, std::span<double> back) const {
  constexpr double steep = 0.3;  // most that a node at a corner goes back is so much farther
  const bool same = part_of_node_[node] == all_.part[side], body = node < body_nodes_;
  const auto ends = all_.side(side);
  if ((!body && !is_body(side)) || std::ranges::count(ends, static_cast<int>(node)) > 0) return;
  const double distance = distance_from(all_, side, q, x);
  Vec<3> out = area_of_side(all_, side, q);
  const double size = std::sqrt(dot(out, out));
  if (size == 0 || std::abs(distance) >= gap) return;
  const double facing = -dot(out, normal[node]) / size;
  if (same && (distance < 0 || facing <= 0)) return;
  const auto hold = [&](std::size_t n, double by) {
    if (n < body_nodes_) back[n] = std::max(back[n], (gap - distance) / std::max(steep, by));
  };
  if (body) return hold(node, facing);
  for (const int n : ends) hold(at(n), dot(out, normal[at(n)]) / size);
}

void FlowSurface::hold_off_walls(std::span<double> q, double gap) const {
  const std::size_t dim = at(all_.dim);
  for (int side = 0; side < 2 * all_.dim; ++side) {
    if (!is_wall(scene_.sides[at(side)])) continue;
    const auto axis = axis_of_side(side);
    const double low = scene_.grid.low[at(axis)] + gap, high = scene_.grid.high(axis) - gap;
    for (std::size_t k = at(axis); k < body_nodes_ * dim; k += dim)
      q[k] = is_low_side(side) ? std::max(q[k], low) : std::min(q[k], high);
  }
}

}  // namespace tether::coupled
