// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "solvers/coupled/coupled_step.hpp"
#include "solvers/coupled/smoke_follow.hpp"

// What a step does with smoke.

namespace tether::coupled {

/// What comes in with fluid: through jets, and through open sides that layers outside lie at.
std::vector<SmokeJet> CoupledStep::smoke_sources(double time, double h) const {
  std::vector<SmokeJet> sources = box_.smoke_of_jets(time, h);
  for (int side = 0; side < 2 * coupled_.grid.dim && outside_.has_smoke(); ++side) {
    if (!has_fluid_beyond(coupled_, side)) continue;
    const int axis = axis_of_side(side);
    each_face_of_side(coupled_.grid, side, [&](std::size_t f) {
      if (at_.domain.face[static_cast<std::size_t>(axis)][f] != FaceKind::open) return;
      const int row = std::min(coupled_.grid.place_of_face(axis, f)[1], coupled_.grid.n[1] - 1);
      sources.push_back({axis, f, outside_.density(row), outside_.temperature(row)});
    });
  }
  return sources;
}

void CoupledStep::carry_smoke_along(CoupledState& state, double h) const {
  if (!coupled_.smoke) return;
  const SmokeFlow flow = carry_smoke(at_.domain, state.v, h, smoke_sources(state.time, h), state.smoke);
  settle_smoke(at_.domain, clean_smoke(at_.domain).volume, state.smoke);  // which has no finer place than cells
  state.smoke_flow.smoke_in += flow.smoke_in, state.smoke_flow.smoke_out += flow.smoke_out;
  state.smoke_flow.heat_in += flow.heat_in, state.smoke_flow.heat_out += flow.heat_out;
}

}  // namespace tether::coupled
