// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/vec.hpp"
#include "loops/points.hpp"
#include "model/size.hpp"
#include "physics/points/arrays.hpp"
#include "physics/points/derived.hpp"
#include "physics/points/elements.hpp"
#include "physics/points/fields.hpp"
#include "physics/points/layout.hpp"
#include "physics/points/point_laws.hpp"
#include "physics/points/state.hpp"
#include "physics/points/steps.hpp"

namespace tether::mpm {
namespace {

constexpr double bytes_of_saved_node = 14 * sizeof(double) + 2 * sizeof(double);  // of a checkpoint: state.cpp
constexpr double bytes_of_frame = sizeof(std::uint32_t) + sizeof(Signs) + sizeof(double) + 1;
constexpr double bytes_of_contact = 3 * sizeof(std::uint64_t) + 2 * sizeof(int);
constexpr double bytes_of_rows = sizeof(NodeSums) + sizeof(NodeMotion) + sizeof(Pair) + bytes_of_frame;
constexpr double bytes_of_gas_rows = sizeof(double) + 2 * sizeof(double) + 2 * sizeof(double);  // mass, (4.5), ledger
static_assert(bytes_of_rows - sizeof(double) <= bytes_per_node, "model/size.hpp: a node takes more than it says");
static_assert(bytes_of_gas_rows <= bytes_of_gas_node,
              "model/size.hpp: a node takes more than it says where there is gas");
static_assert(bytes_of_contact + bytes_of_saved_node <= more_bytes_per_node, "model/size.hpp: the same");
// Of a point: its arrays and the work space of sorting and of tangents; strips, and a checkpoint.
constexpr double bytes_of_sorting = sizeof(CellSort::Key) + sizeof(double) + sizeof(int) + 1;
constexpr double bytes_of_tangents = 2 * sizeof(double);
constexpr double bytes_of_strips = sizeof(std::size_t) + 10 * sizeof(double) + 2;
constexpr ArrayBytes bytes_of_point = bytes_of_arrays<Points>(Points::rows());
static_assert(bytes_of_point.always + bytes_of_sorting <= bytes_per_point,
              "model/size.hpp: a point takes more than it says");
static_assert(bytes_of_point.asked + bytes_of_tangents <=
                  bytes_of_field + bytes_of_gas + bytes_of_deformation + bytes_of_membrane,
              "model/size.hpp: a point takes more than it says");
static_assert(bytes_of_saved_arrays(Points::rows()) + bytes_of_strips <= more_bytes_per_point,
              "model/size.hpp: the same");

/// Of the points' mean mass: nodes with less have it from points on a line of the grid, 1e-12 of their masses.
constexpr double light_part = 1e-9;

/// Of a row that stands for several it is that of all of theirs.
double mean_mass(const Points& points, const Scene& scene) {
  const std::size_t count = Unfolding(scene.strip.get()).unfolded(0, points.size());
  return std::accumulate(points.mass.begin(), points.mass.end(), 0.0) / static_cast<double>(count);
}

bool from_cells(const IdealGas& gas) { return gas.rule == DensityRule::cell || gas.rule == DensityRule::quadratic; }

/// Sets what a law keeps at a point beside its stress.
struct StartPoints {
  State& state;
  const Body& body;
  Slots range;
  std::size_t number;  // of the body
  StepFindings found;

  void operator()(const PlaneElastic&) const {}      // the scene's stress is the state
  void operator()(const FiniteElastic& law) const {  // at rest, where F is 1
    state.wave_max = std::max(state.wave_max, law.sound_speed(body.density));
  }
  void operator()(const LinearFluid&) {
    Points& P = state.points;  // an accumulated pressure starts at zero strain
    for_points(P, range, [&](std::size_t p) { P.sxx[p] = P.syy[p] = P.sxy[p] = 0; });  // the other arrays are 0
  }
  /// A stress in the file is an initial strain E eps = t . sigma . t: negative is slack.
  void operator()(const Membrane& law) {
    Points& P = state.points;
    const Range string = range.full();
    for_points(string, [&](std::size_t p) {
      const Vec<2> t = tangent_at(P, string, p, body.closed);
      P.tx[p] = t[0], P.ty[p] = t[1];
    });
    if (state.normals) state.find_tangents(number);
    for_points(string, [&](std::size_t p) {
      const Vec<2> t{P.tx[p], P.ty[p]};
      P.strain[p] = along({P.sxx[p], P.syy[p], P.sxy[p]}, t) / law.E;
      P.hoop[p] = 0;
      law_update<true>(law, P, p, {}, {}, found);
    });
  }
  /// Densities from cells stand in the points already; from nodes, the body's own is right at the start.
  void operator()(const IdealGas& law) {
    Points& P = state.points;
    for_points(P, range, [&](std::size_t p) {
      if (!from_cells(law)) P.rho[p] = body.density;
      P.energy[p] = body.specific_energy;
      if (P.szz.empty())
        law_update<false>(law, P, p, {}, {}, found);
      else
        law_update<true>(law, P, p, {}, {}, found);
    });
    state.wave_max = std::max(state.wave_max, found.wave_max);
    state.c_max = std::max(state.c_max, std::sqrt(found.c_squared_max));
  }
};

/// Follows the rule of the first gas that takes its density from cells: a deck has but one such rule.
std::optional<CellDensity> cell_density(const Scene& scene, const Frame& frame) {
  for (const Body& body : scene.bodies) {
    const auto* gas = std::get_if<IdealGas>(&body.material);
    if (gas && from_cells(*gas)) return CellDensity(frame, scene.walls, scene.geometry, gas->rule, scene.strip.get());
  }
  return std::nullopt;
}

/// A rule of chapter 7 for membranes whose strain is their points'. A padded grid's edges are no walls to it.
void make_normals(const Scene& scene, State& state) {
  const Method& method = scene.method;
  if (method.normals == NormalRule::connectivity || method.membrane_strain == MembraneStrain::element) return;
  std::size_t most = 0;
  for (const Body& body : scene.bodies) {
    if (std::holds_alternative<Membrane>(body.material)) most = std::max(most, body.count);
  }
  if (most == 0) return;
  const Frame& frame = state.grid.frame;
  const Walls open{Wall::open, Wall::open, Wall::open, Wall::open};
  state.normals.emplace(frame.shape, frame.shape == frame.deck ? scene.walls : open, method, most);
  state.old_tx = state.old_ty = std::vector<double>(state.points.size());
}

/// Membranes whose forces come from elements, and those on which only the pressure outside acts so.
void make_elements(const Scene& scene, State& state) {
  const bool elements = state.pins_hold_loads = scene.method.membrane_strain == MembraneStrain::element;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    auto& of = state.elements_of.emplace_back();
    auto& ambient = state.ambient_of.emplace_back();
    if (!std::holds_alternative<Membrane>(scene.bodies[b].material)) continue;
    if (elements)
      of.emplace(scene, b, state.ranges[b].full(), state.points, state.grid.frame);
    else if (scene.ambient != 0)
      ambient.emplace(scene, b, state.ranges[b].full(), state.points, state.grid.frame);
    std::size_t bad = 0;
    if (of) of->update(state.points, bad);
    if (ambient) ambient->update_ambient(state.points);
  }
}

}  // namespace

bool keeps_ledger(const Scene& scene) {
  return scene.method.ledger && std::any_of(scene.bodies.begin(), scene.bodies.end(), [](const Body& body) {
           const auto* gas = std::get_if<IdealGas>(&body.material);
           return gas && gas->rule == DensityRule::grid;
         });
}

void sort_bodies(CellSort& sort, State& state, const Scene& scene) {
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const bool string = std::holds_alternative<Membrane>(scene.bodies[b].material);
    if (!string && !state.blocks[b]) sort(state.points, state.ranges[b].full(), state.grid.frame.shape);
  }
}

State start(const Scene& scene, const LaneChoice& lanes) { return start(scene, scene.points, lanes); }

State start(const Scene& scene, PointSet points, const LaneChoice& lanes) {
  State state(scene, points, lanes);
  state.density = cell_density(scene, state.grid.frame);
  for (const Body& body : scene.bodies) {
    state.ranges.push_back({body.first, body.first + body.count});
    const bool pins = std::any_of(scene.pinned.begin(), scene.pinned.end(),
                                  [&](std::size_t p) { return p >= body.first && p < body.first + body.count; });
    state.has_pins.push_back(pins ? 1 : 0);
  }
  state.light_node = light_part * mean_mass(state.points, scene);
  state.strips.fill(state.body_points(), scene);
  state.list_fluids(scene);
  state.keeps_ledger = keeps_ledger(scene);
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    auto& blocks = state.blocks.emplace_back();
    const Method& method = scene.method;
    const double middle = method.kernel == Kernel::linear ? 0.5 : 0;
    if (lanes.on && runs_by_lanes(scene, b))
      blocks.emplace(state.grid.frame.shape.nx, state.grid.frame.shape.ny, middle);
    if (blocks && !state.lane_passes) state.lane_passes = lane_passes(lanes.set, method, scene.geometry);
  }
  if (state.lane_passes) lay_out(state, scene), state.list_fluids(scene);
  CellSort sort;
  sort_bodies(sort, state, scene);
  if (state.density) state.density->update(state.points, state.gas, state.gas_by_cells);
  make_normals(scene, state);
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    std::visit(StartPoints{state, scene.bodies[b], state.ranges[b], b, {}}, scene.bodies[b].material);
  }
  const StepFindings edges = state.strips.begin(state.body_points(), scene);
  state.c_max = std::max(state.c_max, std::sqrt(edges.c_squared_max));
  state.wave_max = std::max(state.wave_max, edges.wave_max);
  make_elements(scene, state);
  const StepSet set = step_set(scene);
  set.fit_fields(state);
  set.list_active(state);
  set.map_all(state, scene, state.grid.sums);
  state.carried_at_start = sums_of(state, scene).carried;
  state.balance.stored = stored_energy(scene, state, order_within(state)).sum();
  return state;
}

void State::list_fluids(const Scene& scene) {
  gas.clear(), gas_by_cells.clear(), gas_by_nodes.clear(), fluids.clear();
  gas_mass = 0;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const Slots range = ranges[b];
    if (std::holds_alternative<LinearFluid>(scene.bodies[b].material)) fluids.push_back(range);
    const auto* law = std::get_if<IdealGas>(&scene.bodies[b].material);
    if (!law) continue;
    gas.push_back(range), fluids.push_back(range);
    if (from_cells(*law)) gas_by_cells.push_back(range);
    if (law->rule == DensityRule::grid) gas_by_nodes.push_back(range);
    for_points(points, range, [&](std::size_t p) { gas_mass += points.mass[p]; });
  }
}

void State::find_tangents(std::size_t b) {
  normals->update({points.x, points.y, points.id}, ranges[b].full(), fluids, {points.tx, points.ty});
}

void State::turn_tangents(const Scene& scene, std::size_t b) {
  if (!normals) return mpm::turn_tangents(points, ranges[b].full(), scene.bodies[b].closed);
  for_points(ranges[b].full(), [&](std::size_t p) { old_tx[p] = points.tx[p], old_ty[p] = points.ty[p]; });
  find_tangents(b);
  for_points(ranges[b].full(), [&](std::size_t p) {
    const double cosine = points.tx[p] * old_tx[p] + points.ty[p] * old_ty[p];
    points.strain[p] *= cosine * cosine;
  });
}

}  // namespace tether::mpm
