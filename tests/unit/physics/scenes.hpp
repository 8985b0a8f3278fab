// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "plan/plan.hpp"
#include "results/results.hpp"

namespace tether::scenes {

/// A block of points, `per_side` to a cell's side, over cells [i0, i1) x [j0, j1) of a grid with unit cells.
inline void add_block(Scene& scene, const Material& material, int i0, int i1, int j0, int j1, int per_side,
                      double density = 1, double energy = 0) {
  PointSet& P = scene.points;
  const std::size_t first = P.size();
  const double h = 1.0 / per_side;
  for (int b = j0 * per_side; b < j1 * per_side; ++b) {
    for (int a = i0 * per_side; a < i1 * per_side; ++a) {
      P.x.push_back((a + 0.5) * h), P.y.push_back((b + 0.5) * h);
      P.vx.push_back(0), P.vy.push_back(0);
      P.sxx.push_back(0), P.syy.push_back(0), P.sxy.push_back(0);
      P.volume.push_back(h * h), P.mass.push_back(density * h * h);
    }
  }
  scene.bodies.push_back({"block", material, density, energy, first, P.size() - first});
}

/// Unit cells, `nx` by `ny` nodes, all edges open, a step far below the limit of c = 1.
inline Scene open_scene(int nx, int ny) {
  Scene scene;
  scene.grid = BackgroundGrid(nx, ny, 0, nx - 1.0, 0, ny - 1.0);
  scene.walls = {Wall::open, Wall::open, Wall::open, Wall::open};
  scene.clock = {1e9, 0.05, 1};
  return scene;
}

/// Velocities of a turning, stretching, shearing motion.
inline void stir(Scene& scene, double scale) {
  PointSet& P = scene.points;
  for (std::size_t p = 0; p < P.size(); ++p) {
    P.vx[p] = scale * (0.3 + std::sin(P.x[p]) - 0.5 * P.y[p]);
    P.vy[p] = scale * (0.1 + 0.5 * P.x[p] * std::cos(P.y[p]));
  }
}

/// A field of a snapshot, empty where it has none of that name.
inline std::vector<double> field(const Snapshot& snapshot, const std::string& name) {
  const auto found = std::find_if(snapshot.fields.begin(), snapshot.fields.end(),
                                  [&](const Field& f) { return f.quantity.name == name; });
  return found == snapshot.fields.end() ? std::vector<double>{} : found->values;
}

}  // namespace tether::scenes
