// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/swings.hpp"

#include <fmt/format.h>

#include "base/numbers.hpp"
#include "grid/mesh.hpp"

namespace tether::coupled {
namespace {

constexpr long long calm_steps = 10;  // after a swing
constexpr double enough = 0.02;       // of a body's speed, which swings reach

/// Of a body's nodes, with r = u - w the part of a velocity that swings and m their masses.
struct Sums {
  double r0_r1 = 0, r1_r1 = 0, w_w = 0, u0_u0 = 0, by_drag = 0;  // [energy]
};

}  // namespace

Swings::Swings(const fem::SolidSystem& system)
    : system_(system), body_(parts_of(system.solids.mesh)), bodies_(count_parts(system.solids.mesh)) {}

/// Vibrations of less than about four steps a period do the same, which no step follows. Where friction takes less in
/// the step than swings, they are the body's own affair.
int Swings::found(const CoupledState& state, const Step& step) const {
  const auto dim = at(system_.dim());
  std::vector<Sums> sums(at(bodies_));
  for (std::size_t k = 0; k < step.w.size(); ++k) {
    if (body_[k / dim] < 0 || system_.held[k] != 0) continue;
    Sums& of = sums[at(body_[k / dim])];
    const double m = system_.lumped[k / dim], r1 = step.w[k] - state.u[k];
    of.r0_r1 += m * state.swing[k] * r1, of.r1_r1 += m * r1 * r1, of.w_w += m * step.w[k] * step.w[k];
    of.u0_u0 += m * state.u[k] * state.u[k], of.by_drag += step.h * step.drag[k] * state.u[k];
  }
  for (int body = 0; body < bodies_; ++body) {
    const Sums& of = sums[at(body)];
    const bool turns = of.r0_r1 < -0.5 * of.r1_r1 && of.r1_r1 > enough * enough * of.w_w && 0.5 * of.r1_r1 < step.heat;
    if (turns || of.by_drag < -of.u0_u0) return body;
  }
  return -1;
}

void Swings::keep(bool swung, std::span<const double> w, CoupledState& state) {
  if (swung) {
    state.calm_steps = calm_steps, ++state.calmed;
  } else if (state.calm_steps > 0) {
    --state.calm_steps, ++state.calmed;
  }
  for (std::size_t k = 0; k < w.size(); ++k) state.swing[k] = state.u[k] - w[k];
}

std::string Swings::text(const CoupledState& state, int body) {
  return fmt::format(
      "t = {:.6g}, step {}: body {} swings to and fro from step to step about the velocity that the fluid lets it "
      "have: this step and the next {} end with that velocity, which damps what bodies do in a few steps; calmed_steps "
      "of summary.txt counts such steps, and shorter ones need fewer",
      state.time, state.steps + 1, body + 1, calm_steps);
}

}  // namespace tether::coupled
