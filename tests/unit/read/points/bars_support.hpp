// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <utility>

#include "model/bars.hpp"

namespace tether::scenes {

/// No body yet, on the square from 0 to `side` with open edges, by finite elements; a step that the bars limit.
inline Scene fem_scene(double side) {
  Scene scene;
  scene.physics = Bars{};
  scene.grid = BackgroundGrid(11, 11, 0, side, 0, side);
  scene.walls = {Wall::open, Wall::open, Wall::open, Wall::open};
  scene.clock = {1e9, 1e9, 0.9};
  return scene;
}

/// Adds a string of these places, each point of this volume and mass.
inline void add_string(Scene& scene, const Membrane& law, const std::vector<std::pair<double, double>>& places,
                       double volume, double mass) {
  PointSet& P = scene.points;
  const std::size_t first = P.size();
  for (const auto& [x, y] : places) {
    P.x.push_back(x), P.y.push_back(y), P.vx.push_back(0), P.vy.push_back(0);
    P.sxx.push_back(0), P.syy.push_back(0), P.sxy.push_back(0);
    P.volume.push_back(volume), P.mass.push_back(mass);
  }
  scene.bodies.push_back({"string", law, mass / volume, 0, first, places.size()});
}

/// n places from (x, y), each (dx, dy) from the one before.
inline std::vector<std::pair<double, double>> row(double x, double y, double dx, double dy, std::size_t n) {
  std::vector<std::pair<double, double>> places;
  for (std::size_t k = 0; k < n; ++k) {
    places.emplace_back(x + static_cast<double>(k) * dx, y + static_cast<double>(k) * dy);
  }
  return places;
}

}  // namespace tether::scenes
