// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/winding.hpp"

#include <cmath>
#include <numbers>

#include "base/index.hpp"

namespace tether {
namespace {

/// By A. Van Oosterom and J. Strackee, IEEE Trans. Biomed. Eng. 30 (1983) 125-126.
double solid_angle(const Vector& a, const Vector& b, const Vector& c) {
  const double la = std::sqrt(dot(a, a)), lb = std::sqrt(dot(b, b)), lc = std::sqrt(dot(c, c));
  return 2 * std::atan2(dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
}

}  // namespace

double turns_about(const SolidSurface& surface, std::span<const double> q, const Vector& x, int but_part) {
  double angle = 0;
  std::array<Vector, 3> to{};
  for (std::size_t s = 0; s < surface.side_count(); ++s) {
    if (surface.part[s] == but_part) continue;
    const auto nodes = surface.side(s);
    for (std::size_t a = 0; a < nodes.size(); ++a) to[a] = minus(place_of(q, nodes[a], surface.dim), x);
    angle +=
        surface.dim == 2 ? std::atan2(cross(to[0], to[1])[2], dot(to[0], to[1])) : solid_angle(to[0], to[1], to[2]);
  }
  return angle / (surface.dim == 2 ? 2 * std::numbers::pi : 4 * std::numbers::pi);
}

}  // namespace tether
