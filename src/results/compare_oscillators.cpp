// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "reference/hung_string.hpp"
#include "results/compare_parts.hpp"
#include "results/signal.hpp"

namespace tether {
namespace {

/// The history's column of the last tracked point, and that of another quantity, beside time.
std::vector<double> tracked_column(const Scene& scene, const History& history, const char* name) {
  return history.column(name + std::string("_") + std::to_string(scene.tracked.size()));
}

/// Height of the tracked mass over where it began.
std::vector<double> height(const Scene& scene, const History& history) {
  auto y = tracked_column(scene, history, "point_y");
  const double start = y.front();
  for (double& value : y) value -= start;
  return y;
}

/// Over the whole run; not a number where it ended before the first lowest place.
double largest_drop(const std::vector<double>& time, const std::vector<double>& y) {
  const double first = first_minimum(time, y).value;
  return std::isnan(first) ? first : -*std::min_element(y.begin(), y.end());
}

template <class Exact>
Table table_of(const std::vector<double>& time, const std::string& name, const Exact& exact) {
  Table table{{"time", name}, {time, {}}};
  for (const double t : time) table.columns[1].push_back(exact(t));
  return table;
}

std::string height_name(const Scene& scene) { return "point_y_" + std::to_string(scene.tracked.size()); }

}  // namespace

Comparison compare_spring(const Scene& scene, const History& history) {
  const SpringMass exact = spring_of(scene);
  const auto time = history.column("time"), y = height(scene, history);
  const double start = tracked_column(scene, history, "point_y").front();
  auto path = exact.positions(time);
  for (double& place : path) place += start;
  return {{relative_merit("period", period_about(time, y, middle(y)), exact.period()),
           relative_merit("largest_drop", largest_drop(time, y), exact.largest_drop(time.back()))},
          {{"time", height_name(scene)}, {time, std::move(path)}}};
}

Comparison compare_string(const Scene& scene, const History& history) {
  const StringBounce exact = string_bounce_of(scene);
  const auto time = history.column("time"), y = height(scene, history);
  const double start = tracked_column(scene, history, "point_y").front();
  // Of a massless string, taut is where the mass hangs lower than the slack allows.
  auto taut = passages(time, y, -exact.slack);
  taut.resize(std::max<std::size_t>(taut.size(), 2), std::numeric_limits<double>::quiet_NaN());
  const auto lowest = first_minimum(time, y);
  return {{relative_merit("taut_time", taut[0], exact.taut_time()),
           relative_merit("largest_drop", -lowest.value, exact.largest_drop()),
           relative_merit("slack_again_time", taut[1], exact.slack_again_time()),
           relative_merit("apex_time", first_maximum_after(time, y, lowest.time).time, exact.apex_time())},
          table_of(time, height_name(scene), [&](double t) { return start + exact.position(t); })};
}

Comparison compare_pendulum(const Scene& scene, const History& history) {
  const Pendulum exact = pendulum_of(scene);
  const double pivot = hung_string(scene).x;
  const auto time = history.column("time"), x = tracked_column(scene, history, "point_x");
  const std::string name = "point_x_" + std::to_string(scene.tracked.size());
  return {{relative_merit("period", period_about(time, x, pivot), exact.period())},
          table_of(time, name, [&](double t) { return pivot + exact.length * std::sin(exact.angle(t)); })};
}

Comparison compare_piston(const Scene& scene, const History& history) {
  const Piston exact = piston_of(scene);
  const auto time = history.column("time"), y = height(scene, history);
  return {{relative_merit("period", period_about(time, y, middle(y)), exact.period())}, {}};
}

}  // namespace tether
