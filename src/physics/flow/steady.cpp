// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/flow/steady.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "algebra/dense.hpp"
#include "base/diagnostics.hpp"

namespace tether::fem {

std::vector<double> MixedRounds::next(std::span<const double> q0, std::span<const double> q1) {
  constexpr std::size_t most = 6;
  using Map = Eigen::Map<const Eigen::VectorXd>;
  const auto size = static_cast<Eigen::Index>(q1.size());
  ends_.emplace_back(Map(q1.data(), size));
  ways_.emplace_back(ends_.back() - Map(q0.data(), size));
  if (ends_.size() > most) ends_.pop_front(), ways_.pop_front();
  Eigen::VectorXd mixed = ends_.back();
  const auto before = static_cast<Eigen::Index>(ends_.size()) - 1;
  if (before > 0) {
    Eigen::MatrixXd of_ways(size, before), of_ends(size, before);
    for (Eigen::Index k = 0; k < before; ++k) {
      const auto n = static_cast<std::size_t>(k);
      of_ways.col(k) = ways_[n + 1] - ways_[n], of_ends.col(k) = ends_[n + 1] - ends_[n];
    }
    mixed -= of_ends * least_squares(of_ways, ways_.back());
  }
  return {mixed.begin(), mixed.end()};
}

namespace {

constexpr int most_rounds = 40;

/// Of the displacements' tolerance what a round's way is to be: where a round leaves 0.9 of the way to the solution, 9
/// ways are still to come.
constexpr double part_of_tolerance = 0.1;

void keep_counts(FlowState& state, const FlowState& of) {
  state.newton_steps = of.newton_steps, state.factorisations = of.factorisations, state.rounds = of.rounds;
}

}  // namespace

FlowReport SteadyBodies::advance(FlowState& state, const FlowStepTime& at) {
  FlowState trial = state;
  FlowStepTime round = at;
  round.settling = step_.immersed()->settling_time(flow_.viscosity);
  FlowReport report;
  std::string last;
  MixedRounds mixed;
  for (int k = 1; k <= most_rounds; ++k) {
    const std::vector<double> q0 = trial.q;
    report = advance_round(trial, round);
    if (!report.converged) break;
    const Way way = this->way(q0, trial.q);
    report.converged = way.round <= std::max(part_of_tolerance * flow_.tolerance * way.all, rounding(round.settling));
    if (report.converged) break;
    report.cause = last = cause(trial, way, k);
    trial.q = mixed.next(q0, trial.q);
  }
  if (report.cause.empty()) report.cause = last;
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

/// Returns what the last digits of places, and of velocities over a round, leave of ways [length].
double SteadyBodies::rounding(double settling) const {
  double farthest = 0;
  for (const double x : flow_.mesh.x) farthest = std::max(farthest, std::abs(x));
  return 16 * std::numeric_limits<double>::epsilon() * (farthest + settling * step_.immersed()->speed_beside());
}

SteadyBodies::Way SteadyBodies::way(std::span<const double> before, std::span<const double> after) const {
  const std::vector<double>& x = step_.immersed()->solids().mesh.x;
  Way way;
  for (std::size_t n = 0; 2 * n < x.size(); ++n) {
    const double of_node = std::hypot(after[2 * n] - before[2 * n], after[2 * n + 1] - before[2 * n + 1]);
    if (of_node > way.round) way.round = of_node, way.node = n;
    way.all = std::max(way.all, std::hypot(after[2 * n] - x[2 * n], after[2 * n + 1] - x[2 * n + 1]));
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
