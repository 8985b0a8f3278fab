// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/mpm/steps.hpp"

#include <cmath>

#include "solvers/mpm/kernels.hpp"
#include "solvers/mpm/tangents.hpp"

namespace tether::mpm {
namespace {

/// Walls: the held components are zero in the momentum AND in the force; a wall that changes only the momentum lets
/// the points take up the force (3.22) and blows up.
void hold(std::uint8_t held, Pair& v) {
  if (held & holds_x) v[0] = 0;
  if (held & holds_y) v[1] = 0;
}

/// (mv)^L = (mv) + dt f, with the body force m b (3.17), (3.19), (3.20), walls.
void solve_momentum(StepWork& work, double dt) {
  Grid& grid = work.state.grid;
  const Pair gravity = pair(0, work.scene.gravity);
  for (const int node : grid.active_nodes) {
    const auto n = static_cast<std::size_t>(node);
    const NodeSums& sum = grid.sums[n];
    const double per_m = 1 / sum.m;  // an active node has mass: Locator::edge
    NodeMotion& motion = grid.motion[n];
    motion.a = sum.force * per_m + gravity;
    motion.u = sum.momentum * per_m + dt * motion.a;
    hold(grid.held[n], motion.a);
    hold(grid.held[n], motion.u);
  }
}

void clear_convected(Grid& grid) {
  for (const int node : grid.active_nodes) grid.convected[static_cast<std::size_t>(node)] = Pair{};
}

void clear_sums(Grid& grid) {
  for (const int node : grid.active_nodes) grid.sums[static_cast<std::size_t>(node)] = {};
}

void clear_forces(Grid& grid) {
  for (const int node : grid.active_nodes) {
    grid.sums[static_cast<std::size_t>(node)].force = Pair{};
  }
}

/// v_i = sum m_p v_p N_i / m_i (3.24), walls.
void divide_convected(Grid& grid) {
  for (const int node : grid.active_nodes) {
    const auto n = static_cast<std::size_t>(node);
    grid.convected[n] *= 1 / grid.sums[n].m;
    hold(grid.held[n], grid.convected[n]);
  }
}

/// The same quotient from the momenta mapped at the start of the step.
void mapped_velocity(Grid& grid) {
  for (const int node : grid.active_nodes) {
    const auto n = static_cast<std::size_t>(node);
    grid.convected[n] = grid.sums[n].momentum;
  }
  divide_convected(grid);
}

void accelerate_and_convect_all(StepWork& work, double dt) {
  State& state = work.state;
  clear_convected(state.grid);
  accelerate_and_convect({0, state.points.size()}, state.points, state.grid, dt);
  divide_convected(state.grid);
}

/// First half of a body whose law needs its neighbours' new places.
template <class Pass>
void strain_where_neighbours_count(StepWork& work, double dt) {
  State& state = work.state;
  for (std::size_t b = 0; b < state.ranges.size(); ++b) {
    const bool waits = std::visit([](const auto& law) { return needs_neighbours(law); }, work.scene.bodies[b].material);
    if (waits) strain_and_move_all<Pass>(state.ranges[b], state.points, state.grid, dt, work.found, work.trouble);
  }
}

/// What neighbours tell once they stand at their new places: densities (4.5), (4.6), and the strains and tangents of
/// strings. A string stretches along the tangent that its force had, so that strain energy takes up what the force
/// gave; then its frame turns. Where the points stay, the force will have the tangent of where they stand.
template <class Pass>
void look_at_neighbours(StepWork& work, double dt) {
  State& state = work.state;
  if (state.density) state.density->update(state.points, state.gas, state.gas_by_cells);
  for (std::size_t b = 0; b < state.ranges.size(); ++b) {
    if (!std::holds_alternative<Uniaxial>(work.scene.bodies[b].material)) continue;
    if constexpr (!Pass::moves) turn_tangents(state.points, state.ranges[b]);
    stretch_along_tangents(state.points, state.ranges[b], dt);
    if constexpr (Pass::moves) turn_tangents(state.points, state.ranges[b]);
  }
}

/// Strain rates (3.23), new places (3.21), stresses by the laws, and the map of mass, momentum and force to the grid
/// that is back in its place (3.15)-(3.18).
template <class Pass>
void strain_stress_and_map_all(StepWork& work, double dt) {
  State& state = work.state;
  const BackgroundGrid& shape = state.grid.shape;
  const StepContext step{dt, state.c_max, std::sqrt(shape.dx * shape.dy)};
  strain_where_neighbours_count<Pass>(work, dt);
  if (work.trouble.kind != TroubleKind::none) return;
  look_at_neighbours<Pass>(work, dt);
  for (std::size_t b = 0; b < state.ranges.size(); ++b) {
    std::visit(
        [&, range = state.ranges[b]](const auto& law) {
          if (needs_neighbours(law)) {
            stress_and_map_all<Pass>(law, range, state.points, state.grid, step, work.found, work.trouble);
          } else {
            strain_stress_and_map<Pass>(law, range, state.points, state.grid, step, work.found, work.trouble);
          }
        },
        work.scene.bodies[b].material);
  }
}

}  // namespace

void Musl::step(StepWork& work, double dt) {
  solve_momentum(work, dt);              // (3.19), (3.20), walls
  accelerate_and_convect_all(work, dt);  // (3.22), (3.24), walls
  clear_sums(work.state.grid);
  strain_stress_and_map_all<MuslPass>(work, dt);  // (3.21), (3.23), laws, (3.15)-(3.18)
}

void Usl::step(StepWork& work, double dt) {
  solve_momentum(work, dt);  // (3.19), (3.20), walls
  clear_sums(work.state.grid);
  strain_stress_and_map_all<UslPass>(work, dt);  // (3.22), (3.21), (3.23), laws, (3.15)-(3.18)
}

void Usf::step(StepWork& work, double dt) {
  mapped_velocity(work.state.grid);  // v_i = (mv)_i / m_i, walls
  clear_forces(work.state.grid);
  strain_stress_and_map_all<UsfPass>(work, dt);  // (3.23), laws, (3.16)
  if (work.trouble.kind != TroubleKind::none) return;
  solve_momentum(work, dt);  // (3.19), (3.20), walls
  clear_sums(work.state.grid);
  accelerate_move_and_map({0, work.state.points.size()}, work.state.points, work.state.grid, dt, work.found,
                          work.trouble);  // (3.22), (3.21), (3.15)
}

void map_all(const State& state, const Scene& scene, std::vector<NodeSums>& sums) {
  const Locator locator(state.grid.shape);
  const Points& P = state.points;
  for (std::size_t b = 0; b < state.ranges.size(); ++b) {
    std::visit(
        [&, range = state.ranges[b]](const auto& law) {
          for (std::size_t p = range.begin; p < range.end; ++p) {
            const CellPlace at = locator.locate(P.x[p], P.y[p]);
            const auto nodes = corners(locator, at);
            map_momentum(P, p, sums, nodes, LinearShape(at));
            map_force(P, p, law_volume(law, P, p), sums, nodes, LinearGradient(at, locator.per_dx, locator.per_dy));
          }
        },
        scene.bodies[b].material);
  }
}

}  // namespace tether::mpm
