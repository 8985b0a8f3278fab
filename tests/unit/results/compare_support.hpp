// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

#include "results/compare.hpp"

namespace tether::test {

inline void add_point(PointSet& points, double x, double y, double volume, double mass) {
  points.x.push_back(x), points.y.push_back(y);
  points.vx.push_back(0), points.vy.push_back(0);
  points.sxx.push_back(0), points.syy.push_back(0), points.sxy.push_back(0);
  points.volume.push_back(volume), points.mass.push_back(mass);
}

/// A hanging string of 4 points, 1/2 apart, of E = 8 and the volume 1/4 a point: L = 3/2, A = 1/2, k = E A / L = 8/3.
/// Its last point weighs 2 and is the second that is tracked.
inline Scene hanging_string(ReferenceKind reference) {
  Scene scene;
  scene.gravity = -10;
  scene.walls = {Wall::open, Wall::open, Wall::open, Wall::open};  // what holds it is its first point
  scene.reference = reference;
  for (int k = 0; k < 4; ++k) add_point(scene.points, 1, 3 - 0.5 * k, 0.25, 0.001);
  scene.points.mass[3] = 2;
  scene.bodies = {{"string", Membrane{8, 0, false}, 1, 0, 0, 4}};
  scene.tracked = {0, 3};
  return scene;
}

/// Times k step, k = 0 .. count, of two tracked points: the first stays at rest, the second moves.
inline History history_of(double step, int count, const std::function<double(double)>& x,
                          const std::function<double(double)>& y) {
  History history;
  history.layout.quantities = {{"time", Dimension::time, ""},
                               {"point_x", Dimension::length, "", Per::point},
                               {"point_y", Dimension::length, "", Per::point}};
  history.layout.point_names = {"top", "mass"};
  for (int k = 0; k <= count; ++k) history.records.push_back({k * step, 1, x(k * step), 3, y(k * step)});
  return history;
}

inline const Merit& merit_of(const Comparison& comparison, const std::string& name) {
  for (const Merit& merit : comparison.merits) {
    if (merit.name == name) return merit;
  }
  throw std::out_of_range(name);
}

}  // namespace tether::test
