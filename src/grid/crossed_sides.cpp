// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "base/numbers.hpp"
#include "grid/overlaps.hpp"

// Sides of two bodies that go through each other.

namespace tether {
namespace {

/// The corners of a facet: an edge in the plane, a triangle in space.
using Corners = std::array<Vec<3>, 3>;

double size_of(const Vec<3>& a) { return std::sqrt(dot(a, a)); }

/// Returns whether two numbers are of opposite signs and both larger than `near`.
bool opposite(double a, double b, double near) { return (a > near && b < -near) || (a < -near && b > near); }

/// In the plane: whether each edge has its ends on both sides of the other's line; then where they cross.
bool edges_cross(const Corners& a, const Corners& b, double near, Vec<3>& place) {
  const auto off = [](const Corners& line, const Vec<3>& x) {
    const Vec<3> way = minus(line[1], line[0]), to = minus(x, line[0]);
    return (way[0] * to[1] - way[1] * to[0]) / size_of(way);
  };
  const double from = off(b, a[0]), to = off(b, a[1]);
  if (!opposite(from, to, near) || !opposite(off(a, b[0]), off(a, b[1]), near)) return false;
  const double part = from / (from - to);
  for (std::size_t i = 0; i < 2; ++i) place[i] = a[0][i] + part * (a[1][i] - a[0][i]);
  return true;
}

/// In space: whether an edge goes through a triangle, farther from its rim than `near`.
bool goes_through(const Vec<3>& from, const Vec<3>& to, const Corners& triangle, double near, Vec<3>& place) {
  Vec<3> normal = cross(minus(triangle[1], triangle[0]), minus(triangle[2], triangle[0]));
  const double twice = size_of(normal);
  if (twice == 0) return false;
  for (double& n : normal) n /= twice;
  const double before = dot(normal, minus(from, triangle[0])), after = dot(normal, minus(to, triangle[0]));
  if (!opposite(before, after, near)) return false;
  const double part = before / (before - after);
  for (std::size_t i = 0; i < 3; ++i) place[i] = from[i] + part * (to[i] - from[i]);
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec<3> edge = minus(triangle[(k + 1) % 3], triangle[k]);
    if (dot(normal, cross(edge, minus(place, triangle[k]))) <= near * size_of(edge)) return false;
  }
  return true;
}

bool triangles_cross(const Corners& a, const Corners& b, double near, Vec<3>& place) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (goes_through(a[k], a[(k + 1) % 3], b, near, place) || goes_through(b[k], b[(k + 1) % 3], a, near, place))
      return true;
  }
  return false;
}

}  // namespace

/// The facets of a body that reach into the box of another.
std::vector<std::size_t> OverlapFinder::facets_near(const Part& part, const Part& other,
                                                    std::span<const double> q) const {
  const std::size_t d = at(dim_);
  std::vector<std::size_t> near;
  for (std::size_t f = 0; f < part.facets.size(); f += d) {
    bool meets = true;
    for (std::size_t i = 0; i < d && meets; ++i) {
      double low = INFINITY, high = -INFINITY;
      for (std::size_t a = 0; a < d; ++a) {
        const double x = q[at(part.facets[f + a]) * d + i];
        low = std::min(low, x), high = std::max(high, x);
      }
      meets = low <= other.high[i] && high >= other.low[i];
    }
    if (meets) near.push_back(f);
  }
  return near;
}

bool OverlapFinder::cross(const Part& part, const Part& other, std::span<const double> q, double near,
                          Vec<3>& at_place) const {
  const std::size_t d = at(dim_);
  const auto corners_of = [&](const Part& of, std::size_t f) {
    Corners corners{};
    for (std::size_t a = 0; a < d; ++a) corners[a] = place(q, of.facets[f + a]);
    return corners;
  };
  const std::vector<std::size_t> own = facets_near(part, other, q), others = facets_near(other, part, q);
  for (const std::size_t f : own) {
    const Corners a = corners_of(part, f);
    for (const std::size_t g : others) {
      const Corners b = corners_of(other, g);
      if (d == 2 ? edges_cross(a, b, near, at_place) : triangles_cross(a, b, near, at_place)) return true;
    }
  }
  return false;
}

CrossedSides OverlapFinder::find_crossed(std::span<const double> q) {
  find_boxes(q);
  CrossedSides found;
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    for (std::size_t o = p + 1; o < parts_.size(); ++o) {
      if (!cross(parts_[p], parts_[o], q, std::max(rounding_[p], rounding_[o]), found.place)) continue;
      found.part = static_cast<int>(p), found.other = static_cast<int>(o);
      return found;
    }
  }
  return found;
}

}  // namespace tether
