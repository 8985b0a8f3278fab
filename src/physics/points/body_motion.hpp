// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "grid/boxes.hpp"
#include "physics/common_columns.hpp"
#include "physics/points/arrays.hpp"

namespace tether::mpm {

/// Of a body. Under APIC a point also carries the field about it: D = h^2/4 an axis of C's squares, and of its spin.
struct BodyMotion {
  Pair D{};
  double mass = 0, mx = 0, my = 0, px = 0, py = 0, angular = 0, kinetic = 0;

  void add(const Points& P, std::size_t p) {
    const double m = P.mass[p];
    mass += m, mx += m * P.x[p], my += m * P.y[p];
    px += m * P.vx[p], py += m * P.vy[p];
    angular += m * (P.x[p] * P.vy[p] - P.y[p] * P.vx[p]);
    kinetic += 0.5 * m * (P.vx[p] * P.vx[p] + P.vy[p] * P.vy[p]);
    if (!P.vxx.empty()) add_field(P, p);
  }
  void add_field(const Points& P, std::size_t p) {
    const double m = P.mass[p];
    angular += m * (D[0] * P.vyx[p] - D[1] * P.vxy[p]);
    kinetic +=
        0.5 * m *
        (D[0] * (P.vxx[p] * P.vxx[p] + P.vyx[p] * P.vyx[p]) + D[1] * (P.vxy[p] * P.vxy[p] + P.vyy[p] * P.vyy[p]));
  }
  void add(const BodyMotion& other) {
    mass += other.mass, mx += other.mx, my += other.my, px += other.px, py += other.py;
    angular += other.angular, kinetic += other.kinetic;
  }
  BodySums sums() const { return {mass, {mx / mass, my / mass}, {px / mass, py / mass}}; }
};

/// Sums over a body in the order of its points' numbers, so that constant sums stay constant to the last bit.
inline BodyMotion motion_of(std::span<const std::uint32_t> body, const Points& P, Pair offset) {
  BodyMotion motion{offset};
  for (const std::size_t p : body) motion.add(P, p);
  return motion;
}

}  // namespace tether::mpm
