// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/points/lane_steps.hpp"

#include <algorithm>

namespace tether::mpm {
namespace {

LaneBody lane_body(const Material& material, const StepContext& step) {
  LaneBody body;
  if (const auto* solid = std::get_if<PlaneElastic>(&material)) {
    body.law = LaneLaw::elastic;
    body.own = solid->lambda + 2 * solid->G, body.other = solid->lambda, body.shear = 2 * solid->G;
  }
  if (const auto* gas = std::get_if<IdealGas>(&material)) {
    body.law = gas->rule == DensityRule::grid         ? LaneLaw::gas_of_nodes
               : gas->rule == DensityRule::continuity ? LaneLaw::gas_of_continuity
                                                      : LaneLaw::gas_of_cells;
    body.gm1 = gas->gm1, body.gamma = gas->gm1 + 1, body.mu = gas->mu;
    body.linear = gas->lambda * gas->coef1 * step.g, body.square = gas->lambda * gas->coef2 * step.g * step.g;
    body.local_speed = gas->local_speed, body.c_max = step.c_max;
    body.heats = step.heats, body.heat = step.heat;
  }
  return body;
}

LanePoints lane_points(Points& P, std::size_t first) {
  const auto from = [first](LineArray<double>& array) { return array.empty() ? nullptr : array.data() + first; };
  return {from(P.x),   from(P.y),      from(P.vx),     from(P.vy),  from(P.vxx), from(P.vyx), from(P.vxy),
          from(P.vyy), from(P.mass),   from(P.volume), from(P.sxx), from(P.syy), from(P.sxy), from(P.szz),
          from(P.rho), from(P.energy), from(P.dxx),    from(P.dyy), from(P.dxy), from(P.dzz)};
}

LaneNodes lane_nodes(Grid& grid, bool gas, bool ledger) {
  LaneNodes nodes{.old_x = grid.convected.x.data(),
                  .old_y = grid.convected.y.data(),
                  .new_x = grid.motion.u.x.data(),
                  .new_y = grid.motion.u.y.data(),
                  .a_x = grid.motion.a.x.data(),
                  .a_y = grid.motion.a.y.data(),
                  .rho = grid.gas.rho.data(),
                  .heat = gas && ledger ? grid.gas.heat.data() : nullptr,
                  .squares = ledger ? grid.squares.data() : nullptr,
                  .m = grid.sums.m.data(),
                  .gas = gas ? grid.sums.gas.data() : nullptr,
                  .momentum_x = grid.sums.momentum.x.data(),
                  .momentum_y = grid.sums.momentum.y.data(),
                  .force_x = grid.sums.force.x.data(),
                  .force_y = grid.sums.force.y.data(),
                  .loss = gas && ledger ? grid.loss.data() : nullptr,
                  .convected_x = grid.convected.x.data(),
                  .convected_y = grid.convected.y.data()};
  return nodes;
}

/// In the order of the lanes.
double sum_of(const double (&lanes)[LaneFindings::lanes]) {
  double sum = 0;
  for (const double lane : lanes) sum += lane;
  return sum;
}

}  // namespace

LaneWork lane_work(StepWork& work, const PassWork& pass, std::size_t b) {
  State& state = work.state;
  const auto* law = std::get_if<IdealGas>(&work.scene.bodies[b].material);
  const bool gas = law && law->rule == DensityRule::grid && work.scene.method.order == StressOrder::usf;
  return {.P = lane_points(state.points, state.ranges[b].begin),
          .N = lane_nodes(state.grid, gas, state.keeps_ledger),
          .grid = {pass.locator.x0, pass.locator.y0, pass.locator.per_dx, pass.locator.per_dy, pass.locator.nx},
          .blocks = &*state.blocks[b],
          .body = lane_body(work.scene.bodies[b].material, pass.step),
          .dt = pass.step.dt,
          .records = work.records || state.keeps_ledger || state.contact.on(),
          .reads_stress = state.contact.on() && work.scene.method.order == StressOrder::usf};
}

void join(StepFindings& found, const LaneFindings& lanes, std::size_t first) {
  found.squares += sum_of(lanes.squares);
  found.lifted += sum_of(lanes.lifted), found.heat += sum_of(lanes.heat);
  found.c_squared_max = std::max(found.c_squared_max, lanes.c_squared);
  found.wave_max = std::max(found.wave_max, lanes.wave);
  if (lanes.unsound != LaneFindings::none) found.trouble.note(TroubleKind::unsound, first + lanes.unsound);
}

void strain_and_pull_by_lanes(StepWork& work, const PassWork& pass, std::size_t b) {
  LaneFindings found;
  const LaneWork lanes = lane_work(work, pass, b);
  work.state.lane_passes->strain_and_pull[static_cast<std::size_t>(lanes.body.law)](lanes, found);
  join(work.found, found, work.state.ranges[b].begin);
}

void stress_and_map_by_lanes(StepWork& work, const PassWork& pass, std::size_t b) {
  LaneFindings found;
  const LaneWork lanes = lane_work(work, pass, b);
  work.state.lane_passes->stress_and_map[static_cast<std::size_t>(lanes.body.law)](lanes, found);
  join(work.found, found, work.state.ranges[b].begin);
}

void accelerate_and_convect_by_lanes(StepWork& work, const PassWork& pass, std::size_t b) {
  LaneFindings found;
  work.state.lane_passes->accelerate_and_convect(lane_work(work, pass, b), found);
  join(work.found, found, work.state.ranges[b].begin);
}

}  // namespace tether::mpm
