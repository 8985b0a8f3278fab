// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/bars/fields.hpp"

#include <cmath>

namespace tether::fem {
namespace {

using D = Dimension;

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
  BodySums sums() const { return {mass, {mx / mass, my / mass}, {px / mass, py / mass}}; }
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

/// What fields of points are made from.
struct PointSource {
  const BarState& state;
  const Scene& scene;
  PointStrains means;
  std::vector<double> body = {};
};

Value<PointSource> of(std::vector<double> BarState::*array) {
  return [array](const PointSource& s, std::size_t p) { return (s.state.*array)[p]; };
}

const ColumnTable<ColumnSetting, PointSource>& point_table() {
  using S = PointSource;
  static const ColumnTable<ColumnSetting, S> table({{{
      {"x", D::length, "place, x", of(&BarState::x)},
      {"y", D::length, "place, y", of(&BarState::y)},
      {"id", D::whole, "number of the point, from 1", [](const S&, std::size_t p) { return p + 1; }},
      {"body", D::whole, "number of its body, from 1", [](const S& s, std::size_t p) { return s.body[p]; }},
      {"vx", D::velocity, "velocity, x", of(&BarState::vx)},
      {"vy", D::velocity, "velocity, y", of(&BarState::vy)},
      {"mass", D::mass, "mass", [](const S& s, std::size_t p) { return s.scene.points.mass[p]; }},
      {"strain", D::number, "mean strain of the point's bars",
       [](const S& s, std::size_t p) { return s.means.strain[p]; }},
      {"stress", D::stress, "mean stress along the point's bars, of their sections at the start",
       [](const S& s, std::size_t p) { return s.means.stress[p]; }},
  }}});
  return table;
}

ColumnGroup<BarSetting, BarSums> step_column() {
  return {{{"energy_step", D::energy,
            "part of the total that central differences keep apart from the others, -dt^2 sum f^2/(8 m)",
            &BarSums::of_step}}};
}

}  // namespace

const ColumnTable<BarSetting, BarSums>& bar_table() {
  static const ColumnTable<BarSetting, BarSums> table(
      {energy_columns(), momentum_columns(), plane_spin_column(), step_column(),
       angle_column<BarSetting, BarSums>([](const BarSetting& s) { return s.tracked_angle; }), body_columns(),
       tracked_columns()});
  return table;
}

Columns<BarSums> bar_columns(const Scene& scene) {
  BarSetting setting{{}, scene.outputs.tracked_angle};
  for (const Body& body : scene.bodies) setting.body_names.push_back(body.name);
  for (std::size_t k = 0; k < scene.tracked.size(); ++k) setting.point_names.push_back(tracked_name(scene, k));
  return {bar_table(), setting};
}

double squared_forces_per_mass(const BarState& state, const Scene& scene) {
  double sum = 0;
  for (std::size_t p = 0; p < scene.points.size(); ++p)
    sum += scene.points.mass[p] * (state.ax[p] * state.ax[p] + state.ay[p] * state.ay[p]);
  return sum;
}

BarSums sums_of(const BarState& state, const BarArrays& bars, const Scene& scene, double dt) {
  BarSums s;
  Motion all;
  for (const Motion& body : motions(state, scene)) {
    s.bodies.push_back(body.sums());
    all.add(body);
  }
  s.time = state.time, s.dt = state.dt_last;
  s.kinetic = all.kinetic, s.strain = strain_energy(state, bars), s.potential = -scene.gravity * all.my;
  s.of_step = state.carried_over - 0.125 * dt * dt * squared_forces_per_mass(state, scene);
  s.total = s.kinetic + s.strain + s.potential + s.of_step;
  s.mass = all.mass, s.momentum = {all.px, all.py}, s.angular[2] = all.angular;
  for (const std::size_t p : scene.tracked) s.tracked.push_back({{state.x[p], state.y[p]}, {state.vx[p], state.vy[p]}});
  return s;
}

Snapshot point_fields(const BarState& state, const BarArrays& bars, const Scene& scene) {
  PointSource source{state, scene, PointStrains(state, bars, scene)};
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    source.body.insert(source.body.end(), scene.bodies[b].count, static_cast<double>(b + 1));
  return Columns<PointSource>(point_table(), ColumnSetting{}).snapshot(state.time, scene.points.size(), source);
}

}  // namespace tether::fem
