// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "plan/plan.hpp"

namespace tether::test {

/// A grid of 4 x 4 cells of 1/2 x 1/4, tmax = 1, the deck's step 1/8, and no body.
inline Scene empty_scene() {
  Scene scene;
  scene.grid = BackgroundGrid(5, 5, 0, 2, 0, 1);
  scene.clock = {1, 0.125, 1};
  return scene;
}

/// Adds a body of points with these velocities.
inline void add_body(Scene& scene, const Material& material, double density, double specific_energy,
                     const std::vector<std::pair<double, double>>& velocities) {
  scene.bodies.push_back({"a body", material, density, specific_energy, scene.points.size(), velocities.size()});
  for (const auto& [vx, vy] : velocities) {
    PointSet& points = scene.points;
    points.x.push_back(0.25), points.y.push_back(0.25);
    points.vx.push_back(vx), points.vy.push_back(vy);
    points.sxx.push_back(0), points.syy.push_back(0), points.sxy.push_back(0);
    points.volume.push_back(0.125), points.mass.push_back(0.125 * density);
  }
}

/// gamma = 2: its sound speed at the specific energy 8 is sqrt(2 (1) 8) = 4.
inline IdealGas simple_gas() {
  IdealGas gas;
  gas.gm1 = 1;
  return gas;
}

/// One point at rest of a solid with sqrt(E / rho) = 4, so that the limit is dy / 4 = 1/16.
inline Scene elastic_scene() {
  Scene scene = empty_scene();
  add_body(scene, plane_strain(4, 0.25), 0.25, 0, {{0, 0}});
  return scene;
}

}  // namespace tether::test
