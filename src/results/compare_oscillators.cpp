// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "reference/pendulum.hpp"
#include "reference/piston.hpp"
#include "reference/spring.hpp"
#include "reference/string_bounce.hpp"
#include "results/compare_parts.hpp"
#include "results/signal.hpp"

namespace tether {
namespace {

/// A string from a particle file as one spring between its end points, its last point the mass.
struct StringAsSpring {
  double length, spacing, area, stiffness, mass, slack;

  explicit StringAsSpring(const Scene& scene) {
    const Body& body = *find_body<Membrane>(scene);
    const PointSet& P = scene.points;
    const double E = std::get<Membrane>(body.material).E;
    const std::size_t first = body.first, last = body.first + body.count - 1;
    length = std::hypot(P.x[last] - P.x[first], P.y[last] - P.y[first]);
    spacing = length / static_cast<double>(body.count - 1);
    area = P.volume[first] / spacing;
    stiffness = E * area / length;
    mass = P.mass[last];
    slack = 0;
    for (std::size_t p = first; p <= last; ++p) slack += spacing * std::max(0.0, -(P.sxx[p] + P.syy[p]) / E);
  }
};

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

/// The fluid's rows of points lie half a spacing inside its ends; its area is its volume over its length.
struct FluidColumn {
  double length, area;

  FluidColumn(const Scene& scene, const Body& fluid) {
    const PointSet& P = scene.points;
    std::set<double> rows;
    double volume = 0;
    for (std::size_t p = fluid.first; p < fluid.first + fluid.count; ++p) {
      rows.insert(P.y[p]);
      volume += P.volume[p];
    }
    const double n = static_cast<double>(rows.size());
    length = (*rows.rbegin() - *rows.begin()) * n / (n - 1);
    area = volume / length;
  }
};

template <class Exact>
Table table_of(const std::vector<double>& time, const std::string& name, const Exact& exact) {
  Table table{{"time", name}, {time, {}}};
  for (const double t : time) table.columns[1].push_back(exact(t));
  return table;
}

std::string height_name(const Scene& scene) { return "point_y_" + std::to_string(scene.tracked.size()); }

}  // namespace

Comparison compare_spring(const Scene& scene, const History& history) {
  const StringAsSpring spring(scene);
  const SpringMass exact{spring.mass, spring.stiffness, -scene.gravity};
  const auto time = history.column("time"), y = height(scene, history);
  const double start = tracked_column(scene, history, "point_y").front();
  return {{relative_merit("period", period_about(time, y, middle(y)), exact.period()),
           relative_merit("largest_drop", largest_drop(time, y), exact.largest_drop())},
          table_of(time, height_name(scene), [&](double t) { return start + exact.position(t); })};
}

Comparison compare_string(const Scene& scene, const History& history) {
  const StringAsSpring string(scene);
  const StringBounce exact{string.mass, string.stiffness, -scene.gravity, string.slack};
  const auto time = history.column("time"), y = height(scene, history);
  const double start = tracked_column(scene, history, "point_y").front();
  // Of a massless string, taut is where the mass hangs lower than the slack allows.
  auto taut = passages(time, y, -string.slack);
  taut.resize(std::max<std::size_t>(taut.size(), 2), std::numeric_limits<double>::quiet_NaN());
  const auto lowest = first_minimum(time, y);
  return {{relative_merit("taut_time", taut[0], exact.taut_time()),
           relative_merit("largest_drop", -lowest.value, exact.largest_drop()),
           relative_merit("slack_again_time", taut[1], exact.slack_again_time()),
           relative_merit("apex_time", first_maximum_after(time, y, lowest.time).time, exact.apex_time())},
          table_of(time, height_name(scene), [&](double t) { return start + exact.position(t); })};
}

Comparison compare_pendulum(const Scene& scene, const History& history) {
  const Body& body = *find_body<Membrane>(scene);
  const PointSet& P = scene.points;
  const std::size_t first = body.first, last = body.first + body.count - 1;
  const double across = P.x[last] - P.x[first], down = P.y[first] - P.y[last];
  const Pendulum exact{std::hypot(across, down), -scene.gravity, std::atan2(across, down)};
  const auto time = history.column("time"), x = tracked_column(scene, history, "point_x");
  const std::string name = "point_x_" + std::to_string(scene.tracked.size());
  return {{relative_merit("period", period_about(time, x, P.x[first]), exact.period())},
          table_of(time, name, [&](double t) { return P.x[first] + exact.length * std::sin(exact.angle(t)); })};
}

Comparison compare_piston(const Scene& scene, const History& history) {
  const StringAsSpring spring(scene);
  const Body& fluid = *find_body<LinearFluid>(scene);
  const FluidColumn column(scene, fluid);
  const Piston exact{spring.mass,   spring.stiffness, column.area,
                     column.length, fluid.density,    std::get<LinearFluid>(fluid.material).beta};
  const auto time = history.column("time"), y = height(scene, history);
  return {{relative_merit("period", period_about(time, y, middle(y)), exact.period())}, {}};
}

}  // namespace tether
