// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/mpm/tangents.hpp"

#include <cmath>

#include "loops/points.hpp"

namespace tether::mpm {

Vec2 tangent_at(const Points& points, Range string, std::size_t p, bool closed) {
  const std::size_t before = p > string.begin ? p - 1 : closed ? string.end - 1 : p;
  const std::size_t behind = p + 1 < string.end ? p + 1 : closed ? string.begin : p;
  const double dx = points.x[behind] - points.x[before], dy = points.y[behind] - points.y[before];
  const double length = std::sqrt(dx * dx + dy * dy);
  return length > 0 ? Vec2{dx / length, dy / length} : Vec2{};
}

void stretch_along_tangents(Points& P, Range string, double dt) {
  for_points(string, [&](std::size_t p) {
    P.strain[p] += dt * along({P.dxx[p], P.dyy[p], P.dxy[p]}, {P.tx[p], P.ty[p]});
    P.hoop[p] += dt * P.dzz[p];
  });
}

void turn_tangents(Points& P, Range string, bool closed) {
  for_points(string, [&](std::size_t p) {
    const Vec2 t = tangent_at(P, string, p, closed);
    if (t.x == 0 && t.y == 0) return;
    const double cosine = t.x * P.tx[p] + t.y * P.ty[p];
    P.strain[p] *= cosine * cosine;
    P.tx[p] = t.x, P.ty[p] = t.y;
  });
}

}  // namespace tether::mpm
