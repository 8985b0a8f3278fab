// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/fem/steady_bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/errors.hpp"

namespace tether::fem {
namespace {

constexpr int most_rounds = 60;

/// Ways of successive rounds with one T fall by a ratio r, so that r/(1 - r) of the last is still to come. A ratio near
/// 1, which rounding makes as well, counts as .9.
double way_to_come(double way, double before) {
  const double ratio = std::min(before > 0 ? way / before : 1, 0.9);
  return way * ratio / (1 - ratio);
}

/// Rounds that fall slowly or grow, as the fluid's load changes with the bodies' places, are made shorter: the fluid
/// then resists the way.
double next_settling(double settling, double ratio, double longest) {
  constexpr double slow = 0.7, fast = 0.05;
  return ratio > slow ? 0.1 * settling : ratio < fast ? std::min(longest, 10 * settling) : settling;
}

void keep_counts(FlowState& state, const FlowState& of) {
  state.newton_steps = of.newton_steps, state.factorisations = of.factorisations, state.rounds = of.rounds;
}

}  // namespace

FlowReport SteadyBodies::advance(FlowState& state, const FlowStepTime& at) {
  const double longest = step_.immersed()->settling_time(flow_.viscosity);
  FlowState trial = state;
  FlowStepTime round = at;
  round.settling = longest;
  FlowReport report;
  Way way;
  double before = 0;
  for (int k = 1; k <= most_rounds; ++k) {
    const FlowState start = trial;
    report = advance_round(trial, round);
    if (!report.converged) break;
    way = this->way(start, trial);
    report.converged =
        before > 0 && way_to_come(way.round, before) <= std::max(flow_.tolerance * way.all, rounding(round.settling));
    if (report.converged) break;
    const double next = before > 0 ? next_settling(round.settling, way.round / before, longest) : round.settling;
    before = next == round.settling ? way.round : 0;
    round.settling = next;
    report.cause = cause(trial, way, k);
  }
  if (report.converged)
    state = std::move(trial);
  else
    keep_counts(state, trial);
  return report;
}

/// A body that leaves the fluid's mesh is no end of the run: shorter steps of continuation may keep it inside.
FlowReport SteadyBodies::advance_round(FlowState& state, const FlowStepTime& at) {
  ++state.rounds;
  try {
    return step_.advance(state, at);
  } catch (const RunError& error) {
    FlowReport report;
    report.cause = fmt::format(" (in search of it: {})", error.what());
    return report;
  }
}

/// What the last digits of places, and of velocities over a round, leave of ways [length].
double SteadyBodies::rounding(double settling) const {
  double farthest = 0;
  for (const double x : flow_.mesh.x) farthest = std::max(farthest, std::abs(x));
  return 16 * std::numeric_limits<double>::epsilon() * (farthest + settling * step_.immersed()->speed_beside());
}

SteadyBodies::Way SteadyBodies::way(const FlowState& before, const FlowState& after) const {
  const std::vector<double>& x = step_.immersed()->solids().mesh.x;
  Way way;
  for (std::size_t n = 0; 2 * n < x.size(); ++n) {
    const double of_node = std::hypot(after.q[2 * n] - before.q[2 * n], after.q[2 * n + 1] - before.q[2 * n + 1]);
    if (of_node > way.round) way.round = of_node, way.node = n;
    way.all = std::max(way.all, std::hypot(after.q[2 * n] - x[2 * n], after.q[2 * n + 1] - x[2 * n + 1]));
  }
  return way;
}

std::string SteadyBodies::cause(const FlowState& state, const Way& way, int rounds) const {
  return fmt::format(
      "; the bodies do not come to rest: node {} of the solids went {:.3g} in the last of {} rounds, to "
      "({:.6g}, {:.6g})",
      way.node + 1, way.round, rounds, state.q[2 * way.node], state.q[2 * way.node + 1]);
}

}  // namespace tether::fem
