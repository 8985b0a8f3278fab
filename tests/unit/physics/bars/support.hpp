// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "plan/make_plan.hpp"
#include "run/make.hpp"
#include "unit/read/points/bars_support.hpp"

namespace tether::scenes {

using std::numbers::pi;

/// A scene under way by its solver, and the history it would write.
class RunningBars {
 public:
  explicit RunningBars(Scene scene) : plan_(make_plan(std::move(scene))), solver_(make_solver(plan_)) {
    history_ = {solver_->history_layout(), {solver_->record()}};
  }
  /// Steps until this time, with a record of every step.
  RunningBars& until(double time) {
    while (solver_->time() < std::min(time, plan_.scene.clock.tmax)) {
      solver_->advance(std::nextafter(solver_->time(), std::numeric_limits<double>::infinity()));
      history_.records.push_back(solver_->record());
    }
    return *this;
  }
  std::vector<double> column(const std::string& name) const { return history_.column(name); }
  double now(const std::string& name) const { return history_.column(name).back(); }
  double field(const std::string& name, std::size_t p) const {
    for (const Field& field : solver_->points().fields) {
      if (field.quantity.name == name) return field.values.at(p);
    }
    throw std::out_of_range(name);
  }
  Solver& solver() { return *solver_; }
  const Plan& plan() const { return plan_; }

 private:
  Plan plan_;
  std::unique_ptr<Solver> solver_;
  History history_;
};

inline double largest_change(const std::vector<double>& values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value - values.front()));
  return largest;
}

constexpr double E = 400, rho = 4, section = 0.5, length = 8;  // c = 10
constexpr double c = 10;

/// A straight string of n pieces, each with its point in the middle, along the direction (.6, .8).
inline Scene free_string(std::size_t n, double cfl, bool wrinkle) {
  Scene scene = fem_scene(20);
  scene.clock.cfl = cfl;
  const double h = length / static_cast<double>(n), volume = section * h;
  add_string(scene, {E, 0, wrinkle}, row(3 + 0.3 * h, 3 + 0.4 * h, 0.6 * h, 0.8 * h, n), volume, rho * volume);
  scene.tracked = {0};
  return scene;
}

/// The first mode of a free bar, u = a cos(pi s / L) along it, at its largest speed: omega = pi c / L.
inline Scene vibrating_bar(std::size_t n, double cfl) {
  Scene scene = free_string(n, cfl, false);
  for (std::size_t p = 0; p < n; ++p) {
    const double speed = 0.01 * std::cos(pi * (static_cast<double>(p) + 0.5) / static_cast<double>(n));
    scene.points.vx[p] = 0.6 * speed, scene.points.vy[p] = 0.8 * speed;
  }
  return scene;
}

/// Along x nothing turns: the bars are linear.
inline Scene level_bar(double tmax) {
  Scene scene = fem_scene(20);
  scene.clock = {tmax, 1e9, 0.9};
  add_string(scene, {E, 0, false}, row(3, 5, 0.5, 0, 10), 0.25, 1);
  for (std::size_t p = 0; p < 10; ++p) scene.points.vx[p] = 0.1 * std::sin(3.0 * static_cast<double>(p));
  scene.pinned = {4};
  return scene;
}

}  // namespace tether::scenes
