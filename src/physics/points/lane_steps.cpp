// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/points/lane_steps.hpp"

#include <algorithm>

namespace tether::mpm {
namespace {

/// The law of a body that runs by lanes.
LaneLaw law_of(const Material& material, bool jaumann) {
  const auto* gas = std::get_if<IdealGas>(&material);
  if (!gas) return std::holds_alternative<PlaneElastic>(material) && !jaumann ? LaneLaw::elastic : LaneLaw::one_by_one;
  if (gas->rule == DensityRule::grid) return LaneLaw::gas_of_nodes;
  return gas->rule == DensityRule::continuity ? LaneLaw::gas_of_continuity : LaneLaw::gas_of_cells;
}

LaneBody lane_body(const Material& material, const StepContext& step) {
  LaneBody body{.law = law_of(material, step.jaumann)};
  if (const auto* solid = std::get_if<PlaneElastic>(&material)) {
    body.own = solid->lambda + 2 * solid->G, body.other = solid->lambda, body.shear = 2 * solid->G;
  }
  if (const auto* gas = std::get_if<IdealGas>(&material)) {
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

/// Returns what a pass works on.
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
          .about_axis = work.scene.geometry == Geometry::axisymmetric,
          .records = work.records || state.keeps_ledger || state.contact.on(),
          .reads_stress = state.contact.on() && work.scene.method.order == StressOrder::usf};
}

/// Adds what lanes found to what the step found before, `first` being the body's first slot.
void join(StepFindings& found, const LaneFindings& lanes, std::size_t first) {
  found.squares += sum_of(lanes.squares);
  found.lifted += sum_of(lanes.lifted), found.heat += sum_of(lanes.heat);
  found.c_squared_max = std::max(found.c_squared_max, lanes.c_squared);
  found.wave_max = std::max(found.wave_max, lanes.wave);
  if (lanes.unsound != LaneFindings::none) found.trouble.note(TroubleKind::unsound, first + lanes.unsound);
}

/// A law of which points are asked one by one.
template <class Law, bool about_axis>
struct AskedOneByOne {
  const Law& law;
  Points& points;
  std::size_t first;  // slot of the body
  const StepContext& step;

  static double update(const void* asked, std::size_t slot, const PointRate& rate, LaneFindings& lanes) {
    const auto& [law, P, first, step] = *static_cast<const AskedOneByOne*>(asked);
    const std::size_t p = first + slot;
    StepFindings found;
    law_update<about_axis>(law, P, p, {{rate.xx, rate.yy, rate.xy, rate.zz}, rate.spin}, step, found);
    lanes.wave = std::max(lanes.wave, found.wave_max);
    if (lanes.unsound == LaneFindings::none && !sound(law, P, p)) lanes.unsound = slot;
    return law_volume(law, P, p);
  }
};

/// Every strip of a round is swept by whoever is free; those of the next round share nodes with them.
void sweep(Team& team, const LaneWork& work, LanePasses::Pass run, std::vector<LaneFindings>& found) {
  const std::vector<Blocks::Strip>& strips = work.blocks->strips();
  const std::size_t second = work.blocks->second_round();
  const auto sweep_strip = [&](std::size_t k) {
    found[k].begin();
    run(work, strips[k], found[k]);
  };
  team.each(0, second, sweep_strip);
  team.each(second, strips.size(), sweep_strip);
}

template <bool about_axis>
void sweep_one_by_one(Team& team, LaneWork& lanes, const Material& material, const PassWork& pass, std::size_t first,
                      LanePasses::Pass run, std::vector<LaneFindings>& found) {
  std::visit(
      [&]<class Law>(const Law& law) {
        const AskedOneByOne<Law, about_axis> asked{law, pass.P, first, pass.step};
        lanes.body.each = {AskedOneByOne<Law, about_axis>::update, &asked};
        sweep(team, lanes, run, found);
      },
      material);
}

}  // namespace

const std::vector<LaneFindings>& run_by_lanes(StepWork& work, const PassWork& pass, std::size_t b,
                                              LanePasses::Pass run) {
  State& state = work.state;
  std::vector<double*> arrays = arrays_of(state.points);
  for (double*& array : arrays) array += state.ranges[b].begin;
  LaneWork lanes = lane_work(work, pass, b);
  lanes.arrays = arrays;
  const Material& material = work.scene.bodies[b].material;
  const std::size_t first = state.ranges[b].begin;
  std::vector<LaneFindings>& found = state.lane_findings;
  found.resize(lanes.blocks->strips().size());
  if (lanes.body.law != LaneLaw::one_by_one)
    sweep(*state.team, lanes, run, found);
  else if (work.scene.geometry == Geometry::axisymmetric)
    sweep_one_by_one<true>(*state.team, lanes, material, pass, first, run, found);
  else
    sweep_one_by_one<false>(*state.team, lanes, material, pass, first, run, found);
  for (const LaneFindings& strip : found) join(work.found, strip, first);
  return found;
}

LanePasses::Pass of_law(const LanePasses::Pass* passes, const StepWork& work, std::size_t b) {
  return passes[static_cast<std::size_t>(law_of(work.scene.bodies[b].material, work.scene.method.jaumann))];
}

}  // namespace tether::mpm
