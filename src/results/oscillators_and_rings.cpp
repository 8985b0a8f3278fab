// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "reference/hung_string.hpp"
#include "reference/thin_ring.hpp"
#include "results/compare.hpp"
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

namespace {

double distance(const PointSet& points, std::size_t p, std::size_t q) {
  return std::hypot(points.x[q] - points.x[p], points.y[q] - points.y[p]);
}

/// The membrane of a quarter: a chain of points between the bottom wall and the left one.
struct Chain {
  std::size_t first, last;           // in the scene
  std::size_t at_bottom, at_left;    // its ends
  double length = 0, thickness = 0;  // from wall to wall; of the points between the ends

  Chain(const Scene& scene, const Body& body) : first(body.first), last(body.first + body.count - 1) {
    const PointSet& P = scene.points;
    at_bottom = first, at_left = last;
    if (P.y[last] < P.y[first]) std::swap(at_bottom, at_left);
    for (std::size_t p = first; p < last; ++p) length += distance(P, p, p + 1);
    // A point between two others stands for half the way to either: its volume is thickness times that.
    const double between = length - (distance(P, first, first + 1) + distance(P, last - 1, last)) / 2;
    double volume = 0;
    for (std::size_t p = first + 1; p < last; ++p) volume += P.volume[p];
    thickness = volume / between;
    length += P.y[at_bottom] - scene.grid.y0 + P.x[at_left] - scene.grid.x0;
  }
};

ThinRing ring_of(const Scene& scene, const Body& body, const Chain& chain) {
  const auto& law = std::get<Membrane>(body.material);
  ThinRing ring{chain.length, chain.thickness, law.E, law.kind == Membrane::Kind::plane_stress ? law.nu : 0, 0, 0};
  for (const Body& gas : scene.bodies) {
    if (&gas == &body) continue;
    ring.gm1 = std::get<IdealGas>(gas.material).gm1;
    for (std::size_t p = gas.first; p < gas.first + gas.count; ++p) {
      ring.internal_energy += scene.points.mass[p] * gas.specific_energy;
    }
  }
  return ring;
}

double radius_of(const Scene& scene, const Snapshot& last, std::size_t p) {
  return std::hypot(values_of(last, "x")[p] - scene.grid.x0, values_of(last, "y")[p] - scene.grid.y0);
}

/// Mean over the gas points: one point's pressure scatters about it.
double mean_pressure(const Snapshot& last, const Chain& chain) {
  const auto& pressure = values_of(last, "pressure");
  double sum = 0, count = 0;
  for (std::size_t p = 0; p < pressure.size(); ++p) {
    if (p < chain.first || p > chain.last) sum += pressure[p], count += 1;
  }
  return sum / count;
}

/// Mean over the membrane points of the stress along the tangent, the trace of sigma_1' t (x) t.
double mean_tangent_stress(const Snapshot& last, const Chain& chain) {
  const auto &sxx = values_of(last, "sxx"), &syy = values_of(last, "syy");
  double sum = 0;
  for (std::size_t p = chain.first; p <= chain.last; ++p) sum += sxx[p] + syy[p];
  return sum / static_cast<double>(chain.last - chain.first + 1);
}

}  // namespace

Comparison compare_thin_ring(const Scene& scene, const Snapshot& last) {
  const Body& body = *find_body<Membrane>(scene);
  const Chain chain(scene, body);
  const RingAtRest exact = ring_at_rest(ring_of(scene, body, chain));
  return {{relative_merit("radius_x", radius_of(scene, last, chain.at_bottom), exact.radius),
           relative_merit("radius_y", radius_of(scene, last, chain.at_left), exact.radius),
           relative_merit("pressure", mean_pressure(last, chain), exact.pressure),
           relative_merit("stress", mean_tangent_stress(last, chain), exact.hoop_stress)},
          {}};
}

}  // namespace tether
