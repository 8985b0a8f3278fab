// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "base/diagnostics.hpp"
#include "base/numbers.hpp"
#include "physics/box/flow_box.hpp"
#include "physics/box/mesh/outline.hpp"
#include "physics/box/mesh/split_facets.hpp"

namespace tether::coupled {
namespace {

/// The box's sides and obstacles that are boxes, as the faces of bricks: a brick is fluid or part of an obstacle. Their
/// edges are where jets, openings and obstacles end, and between as the sizes of the mesh say.
class Bricks {
 public:
  explicit Bricks(const Coupled& scene) : scene_(scene) {
    for (std::size_t a = 0; a < 3; ++a) find_planes(a);
  }

  void add_to(Outline& outline) {
    for (std::size_t a = 0; a < 3; ++a) add_faces_across(a, outline);
    for (const Box<3>& obstacle : scene_.obstacles) {
      Vec<3> middle{};
      bool inside = true;
      for (std::size_t a = 0; a < 3; ++a) {
        const double from = std::max(obstacle.low[a], planes_[a].front()),
                     to = std::min(obstacle.high[a], planes_[a].back());
        middle[a] = 0.5 * (from + to), inside = inside && from < to;
      }
      if (inside) outline.holes.push_back(middle);
    }
  }

 private:
  void find_planes(std::size_t a) {
    const double low = scene_.grid.low[a], high = scene_.grid.high(static_cast<int>(a)), least = 1e-9 * (high - low);
    std::vector<std::array<double, 2>> fine;  // where the size is that near something
    std::vector<double> ends{low, high};
    const auto add = [&](const Box<3>& box) {
      const std::array of{std::clamp(box.low[a], low, high), std::clamp(box.high[a], low, high)};
      ends.insert(ends.end(), of.begin(), of.end()), fine.push_back(of);
    };
    for (const Jet& jet : scene_.jets) add(jet.patch);
    for (const Opening& opening : scene_.openings) add(opening.patch);
    for (const Box<3>& obstacle : scene_.obstacles) add(obstacle);
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end(), [&](double x, double y) { return y - x <= least; }), ends.end());
    ends.back() = high;
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
      const double middle = 0.5 * (ends[k] + ends[k + 1]);
      const bool near = std::ranges::any_of(fine, [&](const auto& of) { return of[0] < middle && middle < of[1]; });
      const double size = near ? scene_.mesh->near : scene_.mesh->size;
      const int parts = std::max(1, static_cast<int>(std::ceil((ends[k + 1] - ends[k]) / size - 1e-9)));
      for (int i = 0; i < parts; ++i) planes_[a].push_back(ends[k] + (ends[k + 1] - ends[k]) * i / parts);
    }
    planes_[a].push_back(high);
  }

  int count(std::size_t a) const { return static_cast<int>(planes_[a].size()) - 1; }
  /// The obstacle that has a brick, -1: none; -2 beyond the box.
  int obstacle_at(const std::array<int, 3>& brick) const {
    Vec<3> middle{};
    for (std::size_t a = 0; a < 3; ++a) {
      if (brick[a] < 0 || brick[a] >= count(a)) return -2;
      middle[a] = 0.5 * (planes_[a][at(brick[a])] + planes_[a][at(brick[a] + 1)]);
    }
    for (std::size_t k = 0; k < scene_.obstacles.size(); ++k) {
      bool inside = true;
      for (std::size_t a = 0; a < 3; ++a)
        inside = inside && scene_.obstacles[k].low[a] < middle[a] && middle[a] < scene_.obstacles[k].high[a];
      if (inside) return static_cast<int>(k);
    }
    return -1;
  }

  void add_faces_across(std::size_t a, Outline& outline) {
    const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
    for (int i = 0; i <= count(a); ++i) {
      for (int j = 0; j < count(b); ++j) {
        for (int k = 0; k < count(c); ++k) {
          std::array<int, 3> above{};
          above[a] = i, above[b] = j, above[c] = k;
          std::array<int, 3> below = above;
          --below[a];
          const int of_above = obstacle_at(above), of_below = obstacle_at(below);
          if ((of_above == -1) == (of_below == -1)) continue;  // the fluid goes on, or there is none
          const int other = of_above == -1 ? of_below : of_above;
          const Boundary boundary = other == -2 ? Boundary{BoundaryKind::box_side, static_cast<int>(2 * a) + (i > 0)}
                                                : Boundary{BoundaryKind::obstacle, other};
          add_face(above, b, c, boundary, outline);
        }
      }
    }
  }

  /// Two triangles, whose common edges turn from one face to the next.
  void add_face(const std::array<int, 3>& first, std::size_t b, std::size_t c, const Boundary& boundary,
                Outline& outline) {
    std::array<std::size_t, 4> corner{};
    for (std::size_t k = 0; k < 4; ++k) {
      std::array<int, 3> of = first;
      of[b] += k == 1 || k == 2, of[c] += k >= 2;
      corner[k] = place(of, outline);
    }
    const std::size_t turn = at((first[b] + first[c]) % 2);
    outline.facets.push_back({{corner[turn], corner[turn + 1], corner[turn + 2]}, boundary});
    outline.facets.push_back({{corner[turn], corner[turn + 2], corner[(turn + 3) % 4]}, boundary});
  }

  std::size_t place(const std::array<int, 3>& of, Outline& outline) {
    const auto [known, is_new] = places_.try_emplace(of, outline.places.size());
    if (is_new) outline.places.push_back({planes_[0][at(of[0])], planes_[1][at(of[1])], planes_[2][at(of[2])]});
    return known->second;
  }

  const Coupled& scene_;
  std::array<std::vector<double>, 3> planes_;
  std::map<std::array<int, 3>, std::size_t> places_;
};

/// Where along a ray from x a triangle is met; infinite where it is not (T. Moeller, B. Trumbore 1997).
double meets(const Vec<3>& x, const Vec<3>& way, const std::array<Vec<3>, 3>& triangle) {
  const Vec<3> u = minus(triangle[1], triangle[0]), v = minus(triangle[2], triangle[0]), p = cross(way, v);
  const double turn = dot(u, p);
  if (turn == 0) return INFINITY;
  const Vec<3> from = minus(x, triangle[0]), q = cross(from, u);
  const double s = dot(from, p) / turn, t = dot(way, q) / turn, along = dot(v, q) / turn;
  return s >= 0 && t >= 0 && s + t <= 1 && along > 0 ? along : INFINITY;
}

/// A place within the connected body that a side belongs to: half the way across it from the side's middle.
Vec<3> place_within(const SolidSurface& surface, std::size_t side, std::span<const double> places) {
  const auto corners = [&](std::size_t s) {
    const auto nodes = surface.side(s);
    return std::array{place_of(places, nodes[0], 3), place_of(places, nodes[1], 3), place_of(places, nodes[2], 3)};
  };
  const auto first = corners(side);
  Vec<3> x{}, way = area_of_side(surface, side, places);
  for (std::size_t a = 0; a < 3; ++a) x[a] = (first[0][a] + first[1][a] + first[2][a]) / 3, way[a] = -way[a];
  double nearest = INFINITY;
  for (std::size_t s = 0; s < surface.side_count(); ++s) {
    if (s != side && surface.part[s] == surface.part[side]) nearest = std::min(nearest, meets(x, way, corners(s)));
  }
  for (std::size_t a = 0; a < 3; ++a) x[a] += 0.5 * nearest * way[a];
  return x;
}

void check_within(const Coupled& scene, const Vec<3>& x, bool body) {
  for (std::size_t a = 0; a < 3; ++a) {
    if (x[a] > scene.grid.low[a] && x[a] < scene.grid.high(static_cast<int>(a))) continue;
    throw RunError(fmt::format(
        "{} reaches through a side of the box at ({:.6g}, {:.6g}, {:.6g}): in space a mesh of the fluid has "
        "it within the box; flow='grid' does not ask that",
        body ? "a body" : "an obstacle", x[0], x[1], x[2]));
  }
}

}  // namespace

Outline outline_in_space(const Coupled& scene, const FlowSurface& surface, std::span<const double> q, double gap) {
  Outline outline;
  outline.dim = 3;
  if (!scene.cavities_only) Bricks(scene).add_to(outline);
  const SolidSurface& all = surface.all();
  const std::size_t first = outline.facets.size();
  const std::vector<double> places = surface.places_apart(q, gap);
  std::vector<int> known(places.size() / 3, -1);
  std::vector<std::optional<std::size_t>> largest(at(all.parts));  // side of each part
  const auto size = [&](std::size_t s) {
    const Vec<3> area = area_of_side(all, s, places);
    return dot(area, area);
  };
  for (std::size_t s = 0; s < all.side_count(); ++s) {
    if (surface.is_brick(s)) continue;
    Outline::Facet facet{{}, {surface.is_body(s) ? BoundaryKind::solid : BoundaryKind::obstacle, static_cast<int>(s)}};
    const auto nodes = all.side(s);
    for (std::size_t k = 0; k < 3; ++k) {
      int& place = known[at(nodes[k])];
      if (place < 0) {
        const Vec<3> x = place_of(places, nodes[k], 3);
        if (!scene.cavities_only) check_within(scene, x, surface.is_body(s));
        place = static_cast<int>(outline.places.size()), outline.places.push_back(x);
      }
      facet.corners[k] = at(place);
    }
    facet.size = outline.size_of(facet);
    outline.facets.push_back(facet);
    auto& of_part = largest[at(all.part[s])];
    if (!of_part || size(s) > size(*of_part)) of_part = s;
  }
  split_facets(first, scene.mesh->near, outline);
  for (const auto& side : largest) {
    if (side) outline.holes.push_back(place_within(all, *side, places));
  }
  return outline;
}

}  // namespace tether::coupled
