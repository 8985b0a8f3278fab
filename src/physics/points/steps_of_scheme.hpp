// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <utility>

#include "loops/points.hpp"
#include "physics/points/active.hpp"
#include "physics/points/contact_map.hpp"
#include "physics/points/elements.hpp"
#include "physics/points/lane_steps.hpp"
#include "physics/points/membrane_passes.hpp"
#include "physics/points/nodes.hpp"
#include "physics/points/passes.hpp"
#include "physics/points/start_fields.hpp"
#include "physics/points/steps.hpp"

namespace tether::mpm {

// The three orders of a step as pages of named calls, for one scheme of kernel, transfer and geometry.

inline PassWork pass_work(StepWork& work, double dt) {
  State& state = work.state;
  const BackgroundGrid& shape = state.grid.frame.shape;
  const Method& method = work.scene.method;
  return {state.points,
          state.grid,
          Locator(shape),
          {dt, state.c_max, std::sqrt(shape.dx * shape.dy), method.gas_energy == GasEnergy::rate, method.jaumann,
           state.gas_mass > 0 ? state.heat_for_all / state.gas_mass : 0, method.order == StressOrder::usf}};
}

/// Velocities (3.22) and the momenta back on the nodes (3.24).
template <class S>
void accelerate_and_convect_all(StepWork& work, double dt) {
  State& state = work.state;
  clear_convected(state);
  state.contact.clear_convected();
  const PassWork pass = pass_work(work, dt);
  for (std::size_t b = 0; b < state.ranges.size(); ++b) {
    const OwnField own(state, b);
    if (state.blocks[b]) {
      accelerate_and_convect_by_lanes(work, pass, b);
      continue;
    }
    work.found = state.has_pins[b] ? accelerate_and_convect<S, true>(pass, state.ranges[b].full(), work.found)
                                   : accelerate_and_convect<S, false>(pass, state.ranges[b].full(), work.found);
  }
  state.grid.fold_convected();
  divide_convected(state);
  state.contact.divide_convected(state.grid.frame);
}

/// First half of a body whose law needs its neighbours' new places.
template <class S, class Pass>
void strain_where_neighbours_count(StepWork& work, const PassWork& pass) {
  State& state = work.state;
  for (std::size_t b = 0; b < state.ranges.size(); ++b) {
    const OwnField own(state, b);
    const bool later = waits(work.scene.bodies[b].material, Pass::moves);
    if (!later || (state.elements_of[b] && !Pass::moves)) continue;
    if (state.blocks[b]) {  // where the points stay, the stress asks for the rates itself
      if constexpr (Pass::moves) strain_and_move_by_lanes<S>(work, pass, b);
      continue;
    }
    work.found = state.has_pins[b] ? strain_and_move_all<S, Pass, true>(pass, state.ranges[b].full(), work.found)
                                   : strain_and_move_all<S, Pass, false>(pass, state.ranges[b].full(), work.found);
  }
}

/// Finds what neighbours show once they stand at their new places: densities (4.5), (4.6), and the strains and tangents
/// of strings. A string stretches along the tangent that its force had, so that strain energy takes up what the force
/// gave; then its frame turns. Where the points stay, the force will have the tangent of where they stand.
template <class S, class Pass>
void look_at_neighbours(StepWork& work, const PassWork& pass) {
  State& state = work.state;
  if (state.density) state.density->update(state.points, state.gas, state.gas_by_cells);
  if constexpr (Pass::moves) density_at_nodes<S>(pass, state.gas_by_nodes);
  for (std::size_t b = 0; b < state.ranges.size(); ++b) {
    const Body& body = work.scene.bodies[b];
    if (!std::holds_alternative<Membrane>(body.material) || state.elements_of[b]) continue;
    if constexpr (!Pass::moves) state.turn_tangents(work.scene, b);
    stretch_along_tangents(state.points, state.ranges[b].full(), pass.step.dt);
    if constexpr (Pass::moves) state.turn_tangents(work.scene, b);
  }
}

/// Does the same for a body that runs by lanes.
template <class S, class Pass>
void stress_and_map_by_lanes(StepWork& work, const PassWork& pass, std::size_t b) {
  if constexpr (!Pass::moves)
    strain_and_pull_by_lanes(work, pass, b);
  else if (waits(work.scene.bodies[b].material, Pass::moves))
    stress_and_map_moved_by_lanes(work, pass, b);
  else
    strain_move_and_map_by_lanes<S>(work, pass, b);
}

/// Stress of one body and its force, and mass and momentum where it has moved.
template <class S, class Pass>
void stress_and_map_body(StepWork& work, const PassWork& pass, std::size_t b) {
  State& state = work.state;
  const OwnField own(state, b);
  if (state.blocks[b]) return stress_and_map_by_lanes<S, Pass>(work, pass, b);
  const Range range = state.ranges[b].full();
  if (state.elements_of[b]) {
    if constexpr (Pass::moves) map_momentum_all<S>(pass, range);
    return work.found.trouble.join(pull_elements<S>(pass, *state.elements_of[b]));
  }
  std::visit(
      [&](const auto& law) {
        work.found = waits(law, Pass::moves) ? stress_and_map_all<S, Pass>(law, pass, range, work.found)
                                             : strain_stress_and_map<S, Pass>(law, pass, range, work.found);
      },
      work.scene.bodies[b].material);
  if (state.ambient_of[b]) press_ambient<S>(pass, *state.ambient_of[b]);
}

/// Strain rates (3.23), new places (3.21), stresses by the laws, and the map of mass, momentum and force to the grid
/// that is back in its place (3.15)-(3.18).
template <class S, class Pass>
void strain_stress_and_map_all(StepWork& work, double dt) {
  const PassWork pass = pass_work(work, dt);
  strain_where_neighbours_count<S, Pass>(work, pass);
  if (work.found.trouble.kind != TroubleKind::none) return;
  look_at_neighbours<S, Pass>(work, pass);
  for (std::size_t b = 0; b < work.state.ranges.size(); ++b) stress_and_map_body<S, Pass>(work, pass, b);
  work.state.grid.fold_sums();
}

/// Does what remains of a body's step that updated stress first.
template <class S>
void accelerate_move_and_map_body(StepWork& work, const PassWork& pass, std::size_t b) {
  State& state = work.state;
  const OwnField own(state, b);
  if (state.blocks[b]) return accelerate_move_and_map_by_lanes<S>(work, pass, b);
  const Range range = state.ranges[b].full();
  const bool ledger = state.keeps_ledger;
  if (const auto* gas = std::get_if<IdealGas>(&work.scene.bodies[b].material))
    work.found = accelerate_move_and_map_gas<S>(*gas, pass, range, ledger, work.found);
  else if (state.elements_of[b])
    work.found = accelerate_move_and_map_membrane<S>(pass, *state.elements_of[b], ledger, work.found);
  else
    work.found = state.has_pins[b] ? accelerate_move_and_map<S, true>(pass, range, ledger, work.found)
                                   : accelerate_move_and_map<S, false>(pass, range, ledger, work.found);
}

/// Returns whether what a body loses goes to the gas about its points; else it is heat of all gas alike.
inline bool heats_gas_around(const StepWork& work, std::size_t b) {
  return std::holds_alternative<IdealGas>(work.scene.bodies[b].material) || work.state.elements_of[b].has_value();
}

template <class S>
void accelerate_move_and_map_all(StepWork& work, double dt) {
  const PassWork pass = pass_work(work, dt);
  for (std::size_t b = 0; b < work.state.ranges.size(); ++b) {
    const double before = std::exchange(work.found.heat, 0);
    accelerate_move_and_map_body<S>(work, pass, b);
    const double lost = std::exchange(work.found.heat, before);
    if (heats_gas_around(work, b))
      work.found.heat += lost;
    else
      give_to_all_gas(work.state, lost);
  }
  work.state.grid.fold_sums();
}

/// Bodies that share nodes: their own sums there, and which of them move together (A.1.3).
template <class S>
void open_contact(StepWork& work, double dt) {
  State& state = work.state;
  if (!state.contact.on()) return;
  const PassWork pass = pass_work(work, dt);
  find_shared_nodes<S>(pass, state);
  list_near_points<S>(pass, state);
  map_shared_momentum<S>(pass, state);
  state.contact.decide(state.points, state.grid.frame);
}

/// The momentum equation of the common field and, at shared nodes, of each body's.
template <class S>
void solve_with_contact(StepWork& work, double dt, Sums after) {
  State& state = work.state;
  if (!state.contact.on()) return solve_momentum(work, dt, after);
  solve_common_field(work, dt);
  map_shared_force<S>(pass_work(work, dt), state, work.scene);
  state.contact.solve(state.points, state.grid.frame, work.scene.gravity, dt);
  total_with_contact(work, dt);
  if (after == Sums::cleared) clear_sums(state);
}

template <class S>
struct Musl {
  static void step(StepWork& work, double dt) {
    open_contact<S>(work, dt);                         // (9.6)-(9.9)
    solve_with_contact<S>(work, dt, Sums::kept);       // (3.19), (3.20), walls, (9.4), (9.5)
    accelerate_and_convect_all<S>(work, dt);           // (3.22), (3.24), walls
    strain_stress_and_map_all<S, MuslPass>(work, dt);  // (3.21), (3.23), laws, (3.15)-(3.18)
  }
};

template <class S>
struct Usl {
  static void step(StepWork& work, double dt) {
    open_contact<S>(work, dt);                        // (9.6)-(9.9)
    solve_with_contact<S>(work, dt, Sums::cleared);   // (3.19), (3.20), walls, (9.4), (9.5)
    strain_stress_and_map_all<S, UslPass>(work, dt);  // (3.22), (3.21), (3.23), laws, (3.15)-(3.18)
  }
};

template <class S>
struct Usf {
  static void step(StepWork& work, double dt) {
    State& state = work.state;
    mapped_velocity(state);  // v_i = (mv)_i / m_i, walls
    if (!state.gas_by_nodes.empty()) gas_at_nodes(state);
    open_contact<S>(work, dt);  // each body's own field at shared nodes
    clear_forces(state);
    strain_stress_and_map_all<S, UsfPass>(work, dt);  // (3.23), laws, (3.16)
    if (work.found.trouble.kind != TroubleKind::none) return;
    solve_with_contact<S>(work, dt, Sums::cleared);  // (3.19), (3.20), walls, impulses
    if (state.keeps_ledger) clear_heat(state), note_squares(state);
    accelerate_move_and_map_all<S>(work, dt);  // (3.22), (3.21), (4.10) centred, (3.15)
    if (state.keeps_ledger && work.found.trouble.kind == TroubleKind::none) settle_ledger<S>(work, pass_work(work, dt));
  }
};

template <class S>
void map_all_points(const State& state, const Scene& scene, NodeSumsRow& sums) {
  const Locator locator(state.grid.frame.shape);
  const Points& P = state.points;
  for (std::size_t b = 0; b < state.ranges.size(); ++b) {
    std::visit(
        [&, range = state.ranges[b]](const auto& law) {
          for_points(P, range, [&](std::size_t p) {
            if (P.pinned[p] && state.pins_hold_loads) return;
            const auto at = S::Kernel::locate(locator, P.x[p], P.y[p]);
            const auto nodes = S::Kernel::nodes(locator, at);
            if (from_nodes(law))
              map_gas_momentum<S>(P, p, sums, locator, at, nodes);
            else
              map_momentum<S>(P, p, sums, locator, at, nodes);
            if (!state.elements_of[b]) map_force<S>(P, p, law_volume(law, P, p), sums, locator, at, nodes);
          });
        },
        scene.bodies[b].material);
    if (state.elements_of[b]) spread_forces<S>(P, locator, *state.elements_of[b], sums);
    if (state.ambient_of[b]) spread_forces<S>(P, locator, *state.ambient_of[b], sums);
  }
  fold_sums(state.grid.frame.ghosts, sums);
}

template <class S>
void map_quantity(const State& state, const std::vector<double>& q, std::vector<double>& values, Parity parity) {
  const Locator locator(state.grid.frame.shape);
  const Points& P = state.points;
  for_points(P, Slots{0, P.size()}, [&](std::size_t p) {
    if (P.pinned[p] && state.pins_hold_loads) return;
    const auto at = S::Kernel::locate(locator, P.x[p], P.y[p]);
    const auto nodes = S::Kernel::nodes(locator, at);
    const auto N = S::Kernel::values(at);
    for (std::size_t k = 0; k < S::Kernel::size; ++k) values[nodes[k]] += P.mass[p] * q[p] * N[k];
  });
  for (const Ghost& ghost : state.grid.frame.ghosts) {
    const double sign = parity == Parity::even ? 1 : ghost.sign[parity == Parity::of_x ? 0 : 1];
    values[static_cast<std::size_t>(ghost.image)] += sign * values[static_cast<std::size_t>(ghost.node)];
  }
}

template <class S>
StepSet step_set_of(StressOrder order) {
  auto step = order == StressOrder::usf ? Usf<S>::step : order == StressOrder::usl ? Usl<S>::step : Musl<S>::step;
  return {step,
          map_all_points<S>,
          list_active<typename S::Kernel>,
          count_cells<typename S::Kernel>,
          map_quantity<S>,
          gas_pressures<S>,
          fit_fields<S>};
}

/// Chooses by transfer and geometry, for one kernel.
template <class Kernel>
StepSet step_set_of_kernel(const Scene& scene) {
  const StressOrder order = scene.method.order;
  const bool apic = scene.method.transfer == Transfer::apic;
  if (scene.geometry == Geometry::axisymmetric) {
    return apic ? step_set_of<Scheme<Kernel, Apic, Geometry::axisymmetric>>(order)
                : step_set_of<Scheme<Kernel, Flip, Geometry::axisymmetric>>(order);
  }
  return apic ? step_set_of<Scheme<Kernel, Apic, Geometry::plane>>(order)
              : step_set_of<Scheme<Kernel, Flip, Geometry::plane>>(order);
}

}  // namespace tether::mpm
