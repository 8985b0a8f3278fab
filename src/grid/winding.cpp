// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/winding.hpp"

#include <cmath>
#include <numbers>

namespace tether {
namespace {

double turn_of_edge(const Vec<3>& a, const Vec<3>& b) {
  return std::atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]) / (2 * std::numbers::pi);
}

/// The part of all directions that a triangle takes (A. van Oosterom and J. Strackee, IEEE Trans. Biomed. Eng. 30
/// (1983) 125-126).
double part_of_triangle(const Vec<3>& a, const Vec<3>& b, const Vec<3>& c) {
  const double la = std::sqrt(dot(a, a)), lb = std::sqrt(dot(b, b)), lc = std::sqrt(dot(c, c));
  const double volume = dot(a, cross(b, c));
  return std::atan2(volume, la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb) / (2 * std::numbers::pi);
}

}  // namespace

double winding(const SolidSurface& surface, std::span<const double> q, const Vec<3>& place) {
  double turns = 0;
  for (std::size_t s = 0; s < surface.side_count(); ++s) {
    const auto nodes = surface.side(s);
    const auto from = [&](std::size_t a) { return minus(place_of(q, nodes[a], surface.dim), place); };
    turns += surface.dim == 2 ? turn_of_edge(from(0), from(1)) : part_of_triangle(from(0), from(1), from(2));
  }
  return turns;
}

}  // namespace tether
