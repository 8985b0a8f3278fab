// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/liquid/particles.hpp"

#include <cstdint>

#include "base/blocks.hpp"

namespace tether::liquid {

void Particles::add(int dim, const Vec<3>& place, const Vec<3>& velocity, double of_volume) {
  for (std::size_t a = 0; a < static_cast<std::size_t>(dim); ++a) {
    x[a].push_back(place[a]), v[a].push_back(velocity[a]);
    for (std::size_t b = 0; b < static_cast<std::size_t>(dim); ++b) slope[a][b].push_back(0);
  }
  volume.push_back(of_volume);
}

CellParticles sort_by_cells(Team& team, const StaggeredGrid& grid, Particles& particles) {
  CellParticles cells{std::vector<std::size_t>(grid.cell_count() + 1, 0)};
  std::vector<std::uint32_t> cell(particles.size()), from(particles.size());
  each_block(team, cell.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k)
      cell[k] = static_cast<std::uint32_t>(grid.cell(cell_of(grid, place_of(particles, grid.dim, k))));
  });
  for (const std::uint32_t c : cell) ++cells.first[c + 1];
  for (std::size_t c = 0; c + 1 < cells.first.size(); ++c) cells.first[c + 1] += cells.first[c];
  std::vector<std::size_t> next(cells.first.begin(), cells.first.end() - 1);
  for (std::size_t k = 0; k < cell.size(); ++k) from[next[cell[k]]++] = static_cast<std::uint32_t>(k);
  std::vector<std::vector<double>*> lists;
  each_list(particles, [&](const std::string&, std::vector<double>& list) {
    if (!list.empty()) lists.push_back(&list);
  });
  team.each(0, lists.size(), [&](std::size_t l) {
    std::vector<double> sorted(from.size());
    for (std::size_t k = 0; k < from.size(); ++k) sorted[k] = (*lists[l])[from[k]];
    lists[l]->swap(sorted);
  });
  return cells;
}

}  // namespace tether::liquid
