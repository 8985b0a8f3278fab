// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "physics/points/lanes/work.hpp"
#include "physics/points/movers.hpp"
#include "physics/points/passes.hpp"
#include "physics/points/steps.hpp"

namespace tether::mpm {

// Passes by lanes over the points of a body, and what is left of them to be done one by one: points that have left
// their cells.

/// Runs a pass over the strips of body b and adds what it found to what the step found before, strip by strip.
const std::vector<LaneFindings>& run_by_lanes(StepWork& work, const PassWork& pass, std::size_t b,
                                              LanePasses::Pass run);
/// That of several passes which is for the body's law.
LanePasses::Pass of_law(const LanePasses::Pass* passes, const StepWork& work, std::size_t b);

/// Maps what a point that has left its cell gives to the nodes of its new place: mass and momentum, its part of what
/// the ledger booked, and where its stress is new (`pulls`) its force.
template <class S, bool pulls>
void map_moved(StepWork& work, const PassWork& pass, const Material& material, std::size_t p, double lost,
               const typename S::Kernel::Place& at) {
  State& state = work.state;
  Points& P = state.points;
  const auto nodes = S::Kernel::nodes(pass.locator, at);
  const auto* gas = std::get_if<IdealGas>(&material);
  if (gas && state.keeps_ledger)
    map_gas_momentum_and_loss<S>(P, p, lost / P.mass[p], pass.grid, pass.locator, at, nodes);
  else if (gas && !pulls && gas->rule == DensityRule::grid)
    map_gas_momentum<S>(P, p, pass.grid.sums, pass.locator, at, nodes);
  else
    map_momentum<S>(P, p, pass.grid.sums, pass.locator, at, nodes);
  if constexpr (pulls) {
    const double volume = std::visit([&](const auto& law) { return law_volume(law, P, p); }, material);
    map_force<S>(P, p, volume, pass.grid.sums, pass.locator, at, nodes);
  }
}

/// Gives points that have left their cells new slots; map(p, lost, place) does what else is to be done with each.
template <class S, class Map>
void settle_moved(StepWork& work, const PassWork& pass, std::size_t b, const std::vector<LaneFindings>& strips,
                  const Map& map) {
  const auto some_moved = [](const LaneFindings& strip) { return !strip.moved.empty(); };
  if (std::none_of(strips.begin(), strips.end(), some_moved)) return;
  std::vector<Blocks::Cell> entered;
  Movers movers(work.state, work.scene, b);
  for (const LaneFindings& lanes : strips) {
    if (work.found.trouble.kind != TroubleKind::none) return;
    entered.clear();
    for (const Moved& point : lanes.moved) {
      const std::size_t p = work.state.ranges[b].begin + point.slot;
      typename S::Kernel::Place at{point.cell.cell, point.cell.row, 0, 0};
      if (!accept_place<typename S::Kernel>(work.state.points, p, pass.locator, pass.grid.frame, at, work.found))
        return;
      map(p, point.lost, at);
      entered.push_back({at.j, at.i});
    }
    movers.move(lanes.moved, entered, lanes.numbers);
  }
  movers.settle();
}

/// Strain rates, stresses and forces of a body whose points stay.
inline void strain_and_pull_by_lanes(StepWork& work, const PassWork& pass, std::size_t b) {
  run_by_lanes(work, pass, b, of_law(work.state.lane_passes->strain_and_pull, work, b));
}

/// Velocities of a body's points, and their momenta back on the nodes.
inline void accelerate_and_convect_by_lanes(StepWork& work, const PassWork& pass, std::size_t b) {
  run_by_lanes(work, pass, b, work.state.lane_passes->accelerate_and_convect);
}

/// Stresses of a body that has strained and moved, and all that it gives to the nodes.
inline void stress_and_map_moved_by_lanes(StepWork& work, const PassWork& pass, std::size_t b) {
  run_by_lanes(work, pass, b, work.state.lane_passes->stress_and_map);
}

/// Does what remains of a body's step that updated stress first.
template <class S>
void accelerate_move_and_map_by_lanes(StepWork& work, const PassWork& pass, std::size_t b) {
  const LanePasses& passes = *work.state.lane_passes;
  const std::vector<LaneFindings>& found = run_by_lanes(
      work, pass, b, work.state.keeps_ledger ? passes.accelerate_book_move_and_map : passes.accelerate_move_and_map);
  settle_moved<S>(work, pass, b, found, [&](std::size_t p, double lost, const auto& at) {
    map_moved<S, false>(work, pass, work.scene.bodies[b].material, p, lost, at);
  });
}

/// Strain rates, places, stresses, and all that a body gives to the nodes.
template <class S>
void strain_move_and_map_by_lanes(StepWork& work, const PassWork& pass, std::size_t b) {
  const std::vector<LaneFindings>& found = run_by_lanes(work, pass, b, work.state.lane_passes->strain_move_and_map);
  settle_moved<S>(work, pass, b, found, [&](std::size_t p, double lost, const auto& at) {
    map_moved<S, true>(work, pass, work.scene.bodies[b].material, p, lost, at);
  });
}

/// Strain rates and places of a body whose law waits for its neighbours' new places.
template <class S>
void strain_and_move_by_lanes(StepWork& work, const PassWork& pass, std::size_t b) {
  const std::vector<LaneFindings>& found = run_by_lanes(work, pass, b, work.state.lane_passes->strain_and_move);
  settle_moved<S>(work, pass, b, found, [](std::size_t, double, const auto&) {});
}

}  // namespace tether::mpm
