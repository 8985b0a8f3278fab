// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/coupled/placement.hpp"

#include <algorithm>

namespace tether::coupled {

Placement Placer::at(std::span<const double> q) const {
  Placement at;
  const bool cut = scene_.mode == CouplingMode::cut_cell;
  at.pieces = cut_surface(surface_, q, scene_.grid, cut ? 2 : 1);
  at.crossings = find_crossings(surface_, q, scene_.grid);
  at.domain = box_.around(at.crossings);
  if (cut) {
    at.cut = cut_cells(at.pieces, at.crossings, at.domain);
    at.domain = box_.around(at.crossings, at.cut);
  }
  map(q, at);
  const std::vector<std::uint8_t> pockets = find_pockets(at.domain, at.map);
  if (std::find(pockets.begin(), pockets.end(), 1) == pockets.end()) return at;
  drop_regions(pockets, at.domain);
  map(q, at);
  return at;
}

void Placer::map(std::span<const double> q, Placement& at) const {
  const CutCells* cut = scene_.mode == CouplingMode::cut_cell ? &at.cut : nullptr;
  at.numbers = number_pressures(at.domain);
  const PressureSampler sampler(surface_, q, at.pieces, at.domain);
  const CoupledSurface of{surface_, at.pieces, at.domain, at.numbers, &outside_};
  at.map = map_by_pressures(of, sampler, cut, q.size());
  if (scene_.mode == CouplingMode::paper) at.crossing_map = map_by_crossings(of, at.crossings, q.size());
}

}  // namespace tether::coupled
