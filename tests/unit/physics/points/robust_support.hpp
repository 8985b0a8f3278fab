// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "plan/make_plan.hpp"
#include "read/method.hpp"
#include "run/make.hpp"
#include "unit/physics/scenes.hpp"

// Scenes of the robust set, of membranes, and about an axis; and a run of one of them.

namespace tether::scenes {

/// What the deck's reader makes of a gas for the robust set.
inline IdealGas robust_gas(double mu = 0) {
  return {.gm1 = 0.4, .mu = mu, .lambda = 1, .coef1 = 1, .coef2 = 1, .rule = DensityRule::grid, .local_speed = true};
}

constexpr Walls all_walls(Wall wall) { return {wall, wall, wall, wall}; }

/// An empty scene with a step of its own, which no limit shortens.
inline Scene scene_on(const BackgroundGrid& grid, const Walls& walls, double dt, const Method& method,
                      Geometry geometry = Geometry::plane) {
  Scene scene;
  scene.grid = grid;
  scene.walls = walls;
  scene.clock = {1e9, dt, 0};
  scene.method = method;
  scene.geometry = geometry;
  return scene;
}

struct PointAt {
  double x = 0, y = 0, area = 0;  // area of the cross-section, whatever the geometry
};

/// The points as a body, at rest and free of stress.
inline void add_body(Scene& scene, const Material& material, const std::vector<PointAt>& points, double density,
                     double energy = 0, bool closed = false) {
  PointSet& P = scene.points;
  const std::size_t first = P.size();
  for (const PointAt& point : points) {
    const double volume = point.area * depth(scene.geometry, point.x);
    P.x.push_back(point.x), P.y.push_back(point.y);
    P.vx.push_back(0), P.vy.push_back(0);
    P.sxx.push_back(0), P.syy.push_back(0), P.sxy.push_back(0);
    P.volume.push_back(volume), P.mass.push_back(density * volume);
  }
  scene.bodies.push_back({"body", material, density, energy, first, points.size(), closed});
}

/// Points in the middles of squares of side h, on a lattice through the origin, kept where `in` holds.
inline std::vector<PointAt> lattice(double h, double x0, double x1, double y0, double y1,
                                    const std::function<bool(double, double)>& in = {}) {
  std::vector<PointAt> points;
  for (int j = static_cast<int>(std::lround(y0 / h)); j < static_cast<int>(std::lround(y1 / h)); ++j) {
    for (int i = static_cast<int>(std::lround(x0 / h)); i < static_cast<int>(std::lround(x1 / h)); ++i) {
      const double x = (i + 0.5) * h, y = (j + 0.5) * h;
      if (!in || in(x, y)) points.push_back({x, y, h * h});
    }
  }
  return points;
}

/// n points in the middles of equal pieces of an arc, angles in half turns.
inline std::vector<PointAt> arc(double xc, double yc, double a, double b, double from, double to, int n,
                                double thickness) {
  std::vector<PointAt> points;
  const double mean = 0.5 * (a + b);
  for (int k = 0; k < n; ++k) {
    const double angle = std::numbers::pi * (from + (k + 0.5) / n * (to - from));
    const double piece = std::abs(to - from) * std::numbers::pi * mean / n;
    points.push_back({xc + a * std::cos(angle), yc + b * std::sin(angle), thickness * piece});
  }
  return points;
}

/// n points along a line: in the middles of its pieces, or with `at_ends` from end to end, where they have half pieces.
inline std::vector<PointAt> line(double xa, double ya, double xb, double yb, int n, double thickness,
                                 bool at_ends = false) {
  std::vector<PointAt> points;
  const double length = std::hypot(xb - xa, yb - ya), piece = length / (at_ends ? n - 1 : n);
  for (int k = 0; k < n; ++k) {
    const double part = at_ends ? k / (n - 1.0) : (k + 0.5) / n;
    const bool half = at_ends && (k == 0 || k == n - 1);
    points.push_back({xa + part * (xb - xa), ya + part * (yb - ya), thickness * piece * (half ? 0.5 : 1)});
  }
  return points;
}

inline void set_velocities(Scene& scene, const std::function<Vec<2>(double, double)>& v) {
  PointSet& P = scene.points;
  for (std::size_t p = 0; p < P.size(); ++p) {
    const Vec<2> of = v(P.x[p], P.y[p]);
    P.vx[p] = of[0], P.vy[p] = of[1];
  }
}

/// A scene being run.
class Running {
 public:
  explicit Running(Scene scene) : plan_(std::make_unique<Plan>(make_plan(std::move(scene)))) {
    solver_ = make_solver(*plan_);
  }
  const Scene& scene() const { return plan_->scene; }
  Solver& solver() { return *solver_; }
  const Solver& solver() const { return *solver_; }
  double time() const { return solver_->time(); }
  void until(double time) { solver_->advance(time); }
  void steps(int n) {
    for (int k = 0; k < n; ++k) solver_->advance(std::nextafter(solver_->time(), 1e300));
  }
  /// A column of the history, now.
  double value(const std::string& name) const {
    return History{solver_->history_layout(), {solver_->record()}}.column(name).front();
  }
  /// A field of the points, in the order of the scene.
  std::vector<double> field(const std::string& name) const {
    const Snapshot now = solver_->points();
    return std::find_if(now.fields.begin(), now.fields.end(), [&](const Field& f) { return f.quantity.name == name; })
        ->values;
  }

 private:
  std::unique_ptr<Plan> plan_;
  std::unique_ptr<Solver> solver_;
};

}  // namespace tether::scenes
