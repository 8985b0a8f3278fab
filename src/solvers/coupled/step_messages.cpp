// SPDX-License-Identifier: GPL-3.0-or-later
// What a step warns of: each thing once.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "solvers/coupled/coupled_step.hpp"
#include "solvers/coupled/thin_bodies.hpp"

namespace tether::coupled {

/// A warning once, where the cells are first too wide for the bodies.
void CoupledStep::note_thin_bodies(double time, CoupledState& state) {
  if (coupled_.mode != CouplingMode::cut_cell) return;
  const ThinBodies thin = thin_bodies(at_, surface_);
  if (thin.cells > 0 && state.thin_cells == 0)
    messages_.push_back(fmt::format("t = {:.6g}: {}", time, thin_text(thin, surface_.dim)));
  state.thin_cells = std::max(state.thin_cells, static_cast<long long>(thin.cells));
}

std::vector<std::string> CoupledStep::take_messages() {
  std::vector<std::string> messages = std::exchange(messages_, {});
  for (std::string& message : system_.take_messages()) messages.push_back(std::move(message));
  return messages;
}

}  // namespace tether::coupled
