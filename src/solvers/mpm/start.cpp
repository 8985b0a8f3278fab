// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "scene/size.hpp"
#include "solvers/mpm/point_laws.hpp"
#include "solvers/mpm/sort.hpp"
#include "solvers/mpm/state.hpp"
#include "solvers/mpm/steps.hpp"
#include "solvers/mpm/tangents.hpp"

namespace tether::mpm {
namespace {

constexpr double bytes_of_saved_node = 10 * sizeof(double) + 2 * sizeof(double);  // of a checkpoint: saved.cpp
constexpr double bytes_of_saved_point = 15 * sizeof(double);
constexpr double bytes_of_node =
    sizeof(NodeSums) + sizeof(NodeMotion) + sizeof(Pair) + 1 + 4 + 8 + 4 + 8 + bytes_of_saved_node;
static_assert(bytes_of_node <= bytes_per_node, "scene/size.hpp: a node takes more than it says");
static_assert(21 * sizeof(double) + 3 * sizeof(int) + 8 * sizeof(double) + 16 + bytes_of_saved_point <= bytes_per_point,
              "scene/size.hpp: a point takes more than it says");

/// Sets what a law keeps at a point beside its stress.
struct StartPoints {
  State& state;
  const Body& body;
  Range range;

  void operator()(const PlaneElastic&) const {}  // the scene's stress is the state
  void operator()(const LinearFluid&) const {
    Points& P = state.points;  // an accumulated pressure starts at zero strain
    for (std::size_t p = range.begin; p < range.end; ++p) P.sxx[p] = P.syy[p] = P.sxy[p] = 0;
  }
  /// A stress in the file is an initial strain E eps = t . sigma . t: negative is slack.
  void operator()(const Uniaxial& law) const {
    Points& P = state.points;
    StepFindings none;  // a string tells nothing of itself
    for (std::size_t p = range.begin; p < range.end; ++p) {
      const Vec2 t = tangent_at(P, range, p);
      P.tx[p] = t.x, P.ty[p] = t.y;
      P.strain[p] = along({P.sxx[p], P.syy[p], P.sxy[p]}, t) / law.E;
      law_update(law, P, p, {}, {}, none);
    }
  }
  /// Densities from cells stand in the points already.
  void operator()(const IdealGas& law) const {
    Points& P = state.points;
    StepFindings found;
    for (std::size_t p = range.begin; p < range.end; ++p) {
      if (law.rule == DensityRule::continuity) P.rho[p] = body.density;
      P.energy[p] = body.specific_energy;
      law_update(law, P, p, {}, {}, found);
    }
    state.wave_max = std::max(state.wave_max, found.wave_max);
    state.c_max = std::max(state.c_max, std::sqrt(found.c_squared_max));
  }
};

/// By the rule of the first gas that takes its density from cells: a deck has but one such rule.
std::optional<CellDensity> cell_density(const Scene& scene) {
  for (const Body& body : scene.bodies) {
    const auto* gas = std::get_if<IdealGas>(&body.material);
    if (gas && gas->rule != DensityRule::continuity) return CellDensity(scene.grid, scene.walls, gas->rule);
  }
  return std::nullopt;
}

}  // namespace

State start(const Scene& scene) {
  State state{Points(scene.points), Grid(scene.grid, scene.walls, scene.points.size()), {}, {}, {},
              cell_density(scene)};
  for (const Body& body : scene.bodies) {
    state.ranges.push_back({body.first, body.first + body.count});
    const auto* gas = std::get_if<IdealGas>(&body.material);
    if (gas) state.gas.push_back(state.ranges.back());
    if (gas && gas->rule != DensityRule::continuity) state.gas_by_cells.push_back(state.ranges.back());
  }
  CellSort(scene.points.size())(state.points, state.ranges, scene);
  if (state.density) state.density->update(state.points, state.gas, state.gas_by_cells);
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    std::visit(StartPoints{state, scene.bodies[b], state.ranges[b]}, scene.bodies[b].material);
  }
  state.grid.list_active(state.points);
  map_all(state, scene, state.grid.sums);
  return state;
}

}  // namespace tether::mpm
