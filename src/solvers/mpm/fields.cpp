// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/mpm/fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "solvers/mpm/derived.hpp"
#include "solvers/plane_quantities.hpp"

namespace tether::mpm {
namespace {

const std::vector<Quantity>& scene_quantities() {
  static const std::vector<Quantity> rows{
      {"time", Dimension::time, "time"},
      {"dt", Dimension::time, "length of the last step"},
      {"energy_kinetic", Dimension::energy, "kinetic energy of the points"},
      {"energy_strain", Dimension::energy, "energy stored in solids, strings and linear fluids"},
      {"energy_internal", Dimension::energy, "internal energy of the gas"},
      {"energy_potential", Dimension::energy, "potential energy in gravity, zero at y = 0"},
      {"energy_total", Dimension::energy, "sum of the energies"},
      {"mass", Dimension::mass, "mass of the points"},
      {"momentum_x", Dimension::momentum, "momentum in x"},
      {"momentum_y", Dimension::momentum, "momentum in y"},
      {"angular_momentum_z", Dimension::angular_momentum, "angular momentum about the origin"},
  };
  return rows;
}

/// In the order of record().
const std::vector<Quantity>& edge_quantities() {
  using D = Dimension;
  static const std::vector<Quantity> rows{
      {"edge_mass_in", D::mass, "mass that came in through open edges"},
      {"edge_mass_out", D::mass, "mass that went out through open edges"},
      {"edge_mass_back", D::mass, "mass of both that came in through an outflow or went out through an inflow"},
      {"edge_momentum_x", D::momentum, "momentum in x that came in through open edges, less what went out"},
      {"edge_momentum_y", D::momentum, "momentum in y that came in through open edges, less what went out"},
      {"edge_energy_in", D::energy, "energy that came in through open edges", Per::scene, Book::gained},
      {"edge_energy_out", D::energy, "energy that went out through open edges", Per::scene, Book::given},
  };
  return rows;
}

/// Of a point that has left the grid.
constexpr double gone = std::numeric_limits<double>::quiet_NaN();

/// Of a body. Under APIC a point also carries the field about it: D = h^2/4 an axis of C's squares, and of its spin.
struct Motion {
  Pair D{};
  double mass = 0, mx = 0, my = 0, px = 0, py = 0, angular = 0, kinetic = 0;

  void add(const Points& P, std::size_t p) {
    const double m = P.mass[p];
    mass += m, mx += m * P.x[p], my += m * P.y[p];
    px += m * P.vx[p], py += m * P.vy[p];
    angular += m * (P.x[p] * P.vy[p] - P.y[p] * P.vx[p] + D[0] * P.vyx[p] - D[1] * P.vxy[p]);
    const double field =
        D[0] * (P.vxx[p] * P.vxx[p] + P.vyx[p] * P.vyx[p]) + D[1] * (P.vxy[p] * P.vxy[p] + P.vyy[p] * P.vyy[p]);
    kinetic += 0.5 * m * (P.vx[p] * P.vx[p] + P.vy[p] * P.vy[p] + field);
  }
  void add(const Motion& other) {
    mass += other.mass, mx += other.mx, my += other.my, px += other.px, py += other.py;
    angular += other.angular, kinetic += other.kinetic;
  }
};

/// Sums over a body in the order of its points' numbers, so that constant sums stay constant to the last bit.
Motion motion_of(std::span<const std::size_t> body, const Points& P, Pair D) {
  Motion motion{D};
  for (const std::size_t p : body) motion.add(P, p);
  return motion;
}

/// Slots of the tracked points; past the last slot for one that has left the grid.
std::vector<std::size_t> tracked_slots(const State& state, const Scene& scene, const Order& order) {
  const std::vector<int>& id = state.points.id;
  std::vector<std::size_t> tracked;
  for (const std::size_t number : scene.tracked) {
    if (!state.strips.on()) {  // all are there
      tracked.push_back(order.slots[number]);
      continue;
    }
    const auto found = std::find_if(order.slots.begin(), order.slots.end(),
                                    [&](std::size_t p) { return static_cast<std::size_t>(id[p]) == number; });
    tracked.push_back(found == order.slots.end() ? id.size() : *found);
  }
  return tracked;
}

/// Whether impulses of contact may act: a solid is there, and another body.
bool by_gap(const Scene& scene) {
  return scene.method.contact == ContactRule::gap && scene.bodies.size() > 1 && has_solid(scene);
}

/// Bodies whose volume tells whether a run goes wrong.
bool has_volumes(const Scene& scene) { return has_solid(scene) || find_body<LinearFluid>(scene); }

/// Angle of the line from the first to the last tracked point, from the downward vertical [degrees].
double tracked_angle(const Points& P, std::size_t first, std::size_t last) {
  return std::atan2(P.x[last] - P.x[first], P.y[first] - P.y[last]) * 180 / std::numbers::pi;
}

}  // namespace

HistoryLayout history_layout(const Scene& scene) {
  HistoryLayout layout;
  layout.quantities = scene_quantities();
  if (scene.ambient != 0) {
    layout.quantities.push_back(
        {"energy_ambient", Dimension::energy, "work done against the pressure outside membranes, part of the total"});
  }
  if (keeps_ledger(scene)) {
    layout.quantities.push_back(
        {"energy_ledger", Dimension::energy, "heat that the ledger has given to the gas, part of its internal energy"});
  }
  layout.quantities.push_back(
      {"energy_transfer", Dimension::energy, "energy that went lost between points and nodes", Per::scene, Book::lost});
  layout.quantities.push_back({"energy_walls", Dimension::energy, "energy of what points gave to nodes that walls hold",
                               Per::scene, Book::lost});
  layout.quantities.push_back({"energy_integration", Dimension::energy,
                               "work of the nodes' forces that nothing stored, which is the steps' own error; less "
                               "what the ledger has given back",
                               Per::scene, Book::lost});
  if (by_gap(scene)) {
    layout.quantities.push_back({"energy_contact", Dimension::energy,
                                 "energy that impulses of contact have taken, no longer in the total", Per::scene,
                                 Book::lost});
  }
  if (scene.edges.any()) {
    for (const auto& row : edge_quantities()) layout.quantities.push_back(row);
  }
  if (scene.outputs.tracked_angle) {
    layout.quantities.push_back(
        {"tracked_angle", Dimension::number,
         "degrees from the downward vertical of the line from the first to the last tracked point"});
  }
  for (const auto& row : body_quantities()) layout.quantities.push_back(row);
  if (has_volumes(scene)) {
    layout.quantities.push_back(
        {"body_volume", Dimension::volume, "volume, of membranes that at the start", Per::body});
  }
  if (!scene.tracked.empty()) {
    for (const auto& row : tracked_quantities()) layout.quantities.push_back(row);
  }
  for (const Body& body : scene.bodies) layout.body_names.push_back(body.name);
  for (std::size_t k = 0; k < scene.tracked.size(); ++k) layout.point_names.push_back(tracked_name(scene, k));
  return layout;
}

Record record(const State& state, const Scene& scene) {
  const Points& P = state.points;
  const Order order = order_within(state);
  std::vector<Motion> bodies;
  Motion all;
  const Energies energies = stored_energy(scene, state, order);
  const double quarter = scene.method.kernel == Kernel::bspline ? 0.25 : 0;  // bilinear fields are not orthogonal
  const Pair D = quarter * pair(scene.grid.dx * scene.grid.dx, scene.grid.dy * scene.grid.dy);
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    bodies.push_back(motion_of(order.of(b), P, D));
    all.add(bodies.back());
  }
  const double potential = -scene.gravity * all.my;
  Record values{state.time,
                state.dt_last,
                all.kinetic,
                energies.strain,
                energies.internal,
                potential,
                all.kinetic + energies.strain + energies.internal + potential + energies.ambient,
                all.mass,
                all.px,
                all.py,
                all.angular};
  if (scene.ambient != 0) values.push_back(energies.ambient);
  if (state.keeps_ledger) values.push_back(state.heat_given);
  const Balance& balance = state.balance;
  const double stored = energies.sum() - state.strips.passed().stored;  // without what came in by the edges
  values.insert(values.end(), {balance.transfer, balance.walls, balance.integration(stored)});
  if (by_gap(scene)) values.push_back(state.contact.lost());
  if (state.strips.on()) {
    const Passed& passed = state.strips.passed();
    for (const double value : {passed.mass_in, passed.mass_out, passed.back, passed.momentum_x, passed.momentum_y,
                               passed.energy_in, passed.energy_out})
      values.push_back(value);
  }
  const auto tracked = tracked_slots(state, scene, order);
  const bool all_there = std::none_of(tracked.begin(), tracked.end(), [&](std::size_t p) { return p >= P.size(); });
  if (scene.outputs.tracked_angle) {
    values.push_back(all_there ? tracked_angle(P, tracked.front(), tracked.back()) : gone);
  }
  const auto per_body = [&](auto get) {
    for (const Motion& m : bodies) values.push_back(get(m));
  };
  per_body([](const Motion& m) { return m.mx / m.mass; });
  per_body([](const Motion& m) { return m.my / m.mass; });
  per_body([](const Motion& m) { return m.px / m.mass; });
  per_body([](const Motion& m) { return m.py / m.mass; });
  per_body([](const Motion& m) { return m.mass; });
  if (has_volumes(scene)) {
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) values.push_back(volume_of(scene, b, P, order));
  }
  for (const auto* array : {&P.x, &P.y, &P.vx, &P.vy}) {
    for (const std::size_t p : tracked) values.push_back(p < P.size() ? (*array)[p] : gone);
  }
  return values;
}

}  // namespace tether::mpm
