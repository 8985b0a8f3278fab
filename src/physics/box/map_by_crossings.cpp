// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/numbers.hpp"
#include "physics/box/coupling_map.hpp"

namespace tether::coupled {

CouplingMatrix map_by_crossings(Team& team, const CoupledSurface& of, const Crossings& crossings,
                                std::size_t unknowns) {
  const StaggeredGrid& grid = of.domain.grid;
  SideSums entries(at(side_node_count_of(of.surface.kind)));
  for (int axis = 0; axis < grid.dim; ++axis) {
    for (std::size_t f = 0; f < grid.face_count(axis); ++f) {
      if (crossings.lowest[at(axis)][f] < 0) continue;
      const auto cells = cells_beside(grid, axis, f);
      for (const int end : {0, 1}) {  // each cell sees the surface that is nearest to its middle
        const int row = cells[at(end)] < 0 ? -1 : of.numbers.of_cell[at(cells[at(end)])];
        if (row < 0) continue;
        const int nearest = end == 0 ? crossings.lowest[at(axis)][f] : crossings.highest[at(axis)][f];
        const Crossing& crossing = crossings.all[at(nearest)];
        if (at(crossing.side) >= of.surface.side_count()) continue;  // an obstacle's, which rests
        const double out = end == 0 ? grid.area(axis) : -grid.area(axis);
        const CarrierShares share = of.surface.carried(at(crossing.side), crossing.share);
        entries.begin(crossing.side);
        double* sums = entries.row(row);
        for (int a = 0; a < side_node_count_of(of.surface.kind); ++a) sums[3 * at(a) + at(axis)] += out * share[at(a)];
      }
    }
  }
  std::vector<SideEntries> lists;
  lists.push_back(entries.take());
  const std::vector<Vec<3>> one(of.surface.side_count(), {1, 1, 1});  // the area is that of cells
  return SideMatrix(team, of.surface, EntriesAt::carriers, std::move(lists), of.numbers.cell.size(), unknowns)
      .with(team, one);
}

}  // namespace tether::coupled
