// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/coupled/smoke_follow.hpp"

#include <algorithm>
#include <utility>

namespace tether::coupled {
namespace {

// Gentle: a solid that crosses a cell in some steps leaves its neighbours most of what they gained or lost by it.
constexpr double gentle = 1.0 / 16;

}  // namespace

void settle_smoke(const FlowDomain& domain, const std::vector<double>& own, Smoke& smoke) {
  const Smoke held = smoke;
  for (int axis = 0; axis < domain.grid.dim; ++axis) {
    const auto& kind = domain.face[static_cast<std::size_t>(axis)];
    for (std::size_t f = 0; f < kind.size(); ++f) {
      if (kind[f] != FaceKind::open) continue;
      const auto cells = cells_beside(domain.grid, axis, f);
      if (cells[0] < 0 || cells[1] < 0) continue;
      auto from = static_cast<std::size_t>(cells[0]), to = static_cast<std::size_t>(cells[1]);
      if (domain.kind[from] != CellKind::fluid || domain.kind[to] != CellKind::fluid) continue;
      if (!(own[from] > 0 && own[to] > 0)) continue;
      if (held.volume[from] / own[from] < held.volume[to] / own[to]) std::swap(from, to);
      const double more = held.volume[from] / own[from] - held.volume[to] / own[to],
                   volume = gentle * more * std::min(own[from], own[to]);
      const double smoke_moved = volume * held.density(from), heat_moved = volume * held.temperature(from);
      smoke.volume[from] -= volume, smoke.smoke[from] -= smoke_moved, smoke.heat[from] -= heat_moved;
      smoke.volume[to] += volume, smoke.smoke[to] += smoke_moved, smoke.heat[to] += heat_moved;
    }
  }
}

}  // namespace tether::coupled
