// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/fem/bar_fields.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "solvers/plane_quantities.hpp"

namespace tether::fem {
namespace {

const std::vector<Quantity>& scene_quantities() {
  static const std::vector<Quantity> rows{
      {"time", Dimension::time, "time"},
      {"dt", Dimension::time, "length of the last step"},
      {"energy_kinetic", Dimension::energy, "kinetic energy of the nodes"},
      {"energy_strain", Dimension::energy, "energy stored in the bars"},
      {"energy_internal", Dimension::energy, "internal energy of gas, of which there is none"},
      {"energy_potential", Dimension::energy, "potential energy in gravity, zero at y = 0"},
      {"energy_total", Dimension::energy, "sum of the energies"},
      {"mass", Dimension::mass, "mass of the nodes"},
      {"momentum_x", Dimension::momentum, "momentum in x"},
      {"momentum_y", Dimension::momentum, "momentum in y"},
      {"angular_momentum_z", Dimension::angular_momentum, "angular momentum about the origin"},
      {"energy_step", Dimension::energy,
       "part of the total that central differences keep beside the others, -dt^2 sum f^2/(8 m)"},
  };
  return rows;
}

struct Motion {
  double mass = 0, mx = 0, my = 0, px = 0, py = 0, angular = 0, kinetic = 0;

  void add(const BarState& state, std::size_t p, double m) {
    const double x = state.x[p], y = state.y[p], vx = state.vx[p], vy = state.vy[p];
    mass += m, mx += m * x, my += m * y, px += m * vx, py += m * vy;
    angular += m * (x * vy - y * vx), kinetic += 0.5 * m * (vx * vx + vy * vy);
  }
  void add(const Motion& other) {
    mass += other.mass, mx += other.mx, my += other.my, px += other.px, py += other.py;
    angular += other.angular, kinetic += other.kinetic;
  }
};

std::vector<Motion> motions(const BarState& state, const Scene& scene) {
  std::vector<Motion> bodies;
  for (const Body& body : scene.bodies) {
    Motion& motion = bodies.emplace_back();
    for (std::size_t p = body.first; p < body.first + body.count; ++p) motion.add(state, p, scene.points.mass[p]);
  }
  return bodies;
}

double length_of(const BarState& state, const BarArrays& bars, std::size_t e) {
  return std::hypot(state.x[bars.b[e]] - state.x[bars.a[e]], state.y[bars.b[e]] - state.y[bars.a[e]]);
}

/// sum 1/2 E A L_0 eps^2 over what carries.
double strain_energy(const BarState& state, const BarArrays& bars) {
  double sum = 0;
  for (std::size_t e = 0; e < bars.bars(); ++e) {
    const double strain = carried(bars, e, strain_of(bars, e, length_of(state, bars, e)));
    sum += 0.5 * bars.section_modulus[e] * strain * strain / bars.per_rest[e];
  }
  return sum;
}

/// Angle of the line from the first to the last tracked point, from the downward vertical [degrees].
double tracked_angle(const BarState& state, const Scene& scene) {
  const std::size_t first = scene.tracked.front(), last = scene.tracked.back();
  return std::atan2(state.x[last] - state.x[first], state.y[first] - state.y[last]) * 180 / std::numbers::pi;
}

/// Means over the bars that end at each point.
struct PointStrains {
  std::vector<double> strain, stress;

  PointStrains(const BarState& state, const BarArrays& bars, const Scene& scene) {
    const std::size_t nodes = state.x.size();
    std::vector<double> parts(nodes, 0.0);
    strain.assign(nodes, 0.0), stress.assign(nodes, 0.0);
    for (const Body& body : scene.bodies) modulus.resize(body.first + body.count, std::get<Membrane>(body.material).E);
    for (std::size_t e = 0; e < bars.bars(); ++e) {
      const double now = strain_of(bars, e, length_of(state, bars, e));
      for (const std::size_t n : {bars.a[e], bars.b[e]}) {
        strain[n] += now, stress[n] += modulus[bars.a[e]] * carried(bars, e, now), parts[n] += 1;
      }
    }
    for (std::size_t n = 0; n < nodes; ++n) strain[n] /= parts[n], stress[n] /= parts[n];
    strain.resize(scene.points.size()), stress.resize(scene.points.size());  // anchors are no points
  }

 private:
  std::vector<double> modulus;  // of each point's body
};

Field field(const char* name, Dimension dimension, const char* meaning, std::vector<double> values) {
  return {{name, dimension, meaning, Per::scene}, std::move(values)};
}

/// An array of the nodes without the anchors.
std::vector<double> of_points(const std::vector<double>& array, const Scene& scene) {
  return {array.begin(), array.begin() + static_cast<std::ptrdiff_t>(scene.points.size())};
}

}  // namespace

HistoryLayout history_layout(const Scene& scene) {
  HistoryLayout layout;
  layout.quantities = scene_quantities();
  if (scene.outputs.tracked_angle) {
    layout.quantities.push_back(
        {"tracked_angle", Dimension::number,
         "degrees from the downward vertical of the line from the first to the last tracked point"});
  }
  for (const auto& row : body_quantities()) layout.quantities.push_back(row);
  if (!scene.tracked.empty()) {
    for (const auto& row : tracked_quantities()) layout.quantities.push_back(row);
  }
  for (const Body& body : scene.bodies) layout.body_names.push_back(body.name);
  for (std::size_t k = 0; k < scene.tracked.size(); ++k) layout.point_names.push_back(tracked_name(scene, k));
  return layout;
}

double squared_forces_per_mass(const BarState& state, const Scene& scene) {
  double sum = 0;
  for (std::size_t p = 0; p < scene.points.size(); ++p)
    sum += scene.points.mass[p] * (state.ax[p] * state.ax[p] + state.ay[p] * state.ay[p]);
  return sum;
}

Record record(const BarState& state, const BarArrays& bars, const Scene& scene, double dt) {
  const auto bodies = motions(state, scene);
  Motion all;
  for (const Motion& body : bodies) all.add(body);
  const double strain = strain_energy(state, bars), potential = -scene.gravity * all.my;
  const double of_step = state.carried_over - 0.125 * dt * dt * squared_forces_per_mass(state, scene);
  Record values{state.time,
                state.dt_last,
                all.kinetic,
                strain,
                0,
                potential,
                all.kinetic + strain + potential + of_step,
                all.mass,
                all.px,
                all.py,
                all.angular,
                of_step};
  if (scene.outputs.tracked_angle) values.push_back(tracked_angle(state, scene));
  const auto per_body = [&](auto get) {
    for (const Motion& body : bodies) values.push_back(get(body));
  };
  per_body([](const Motion& m) { return m.mx / m.mass; });
  per_body([](const Motion& m) { return m.my / m.mass; });
  per_body([](const Motion& m) { return m.px / m.mass; });
  per_body([](const Motion& m) { return m.py / m.mass; });
  per_body([](const Motion& m) { return m.mass; });
  for (const auto* array : {&state.x, &state.y, &state.vx, &state.vy}) {
    for (const std::size_t p : scene.tracked) values.push_back((*array)[p]);
  }
  return values;
}

Snapshot point_fields(const BarState& state, const BarArrays& bars, const Scene& scene) {
  PointStrains means(state, bars, scene);
  std::vector<double> id, body;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    for (std::size_t k = 0; k < scene.bodies[b].count; ++k) {
      id.push_back(static_cast<double>(id.size() + 1)), body.push_back(static_cast<double>(b + 1));
    }
  }
  const auto of = [&](const std::vector<double>& array) { return of_points(array, scene); };
  using D = Dimension;
  return {state.time,
          {field("x", D::length, "place, x", of(state.x)), field("y", D::length, "place, y", of(state.y)),
           field("id", D::number, "number of the point, from 1", std::move(id)),
           field("body", D::number, "number of its body, from 1", std::move(body)),
           field("vx", D::velocity, "velocity, x", of(state.vx)), field("vy", D::velocity, "velocity, y", of(state.vy)),
           field("mass", D::mass, "mass", scene.points.mass),
           field("strain", D::number, "mean strain of the point's bars", std::move(means.strain)),
           field("stress", D::stress, "mean stress along the point's bars, of their sections at the start",
                 std::move(means.stress))}};
}

}  // namespace tether::fem
