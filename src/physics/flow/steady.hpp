// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <deque>
#include <span>
#include <string>
#include <vector>

#include "physics/flow/state.hpp"
#include "physics/flow/step.hpp"

namespace tether::fem {

/// Anderson's mixing of rounds q1 = G(q0) that are to end where q stays (D. G. Anderson, J. ACM 12 (1965) 547-560): the
/// next q0 is the sum of the last q1, parts of which add up to 1, whose ways q1 - q0 add up to the least. Rounds whose
/// ways fall by a half, or grow, so fall by a tenth and more each.
class MixedRounds {
 public:
  /// The next start after a round from q0 to q1, all of the same length.
  std::vector<double> next(std::span<const double> q0, std::span<const double> q1);

 private:
  std::deque<Eigen::VectorXd> ends_, ways_;
};

/// Steady solutions of a flow with immersed bodies: v, p and the places q of the bodies' nodes at which the fluid is at
/// rest at the bodies, I(q) v = 0, and takes their stress, excess weight and loads in equilibrium, (55) without
/// inertia.
///
/// A round is a step q1 = q0 + T I(q0) v so long that I v all but vanishes, by Newton's method in v and p. The map
/// I and the pressure's points are those of its start q0, so that rounds go on, mixed, until q stays: then they are
/// taken where the bodies are, and neither T nor the way there counts.
class SteadyBodies {
 public:
  /// The step, which has bodies, and the flow must outlive it.
  SteadyBodies(FlowStep& step, const Flow& flow) : step_(step), flow_(flow) {}

  /// The steady solution at a part (start + dt)/tmax of the loads, from that in the state, or the state as it was but
  /// for its counts where none is found.
  FlowReport advance(FlowState& state, const FlowStepTime& at);

 private:
  /// How far a round has taken the bodies' nodes and how far they are from the reference shape, at the most [length];
  /// the node that went furthest.
  struct Way {
    double round = 0, all = 0;
    std::size_t node = 0;
  };
  FlowReport advance_round(FlowState& state, const FlowStepTime& at);
  double rounding(double settling) const;
  Way way(std::span<const double> before, std::span<const double> after) const;
  std::string cause(const FlowState& state, const Way& way, int rounds) const;

  FlowStep& step_;
  const Flow& flow_;
};

}  // namespace tether::fem
