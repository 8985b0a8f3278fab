// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "base/team.hpp"
#include "grid/boxes.hpp"

namespace tether::liquid {

/// The liquid as particles, each of which carries a volume that never changes. Lists have a number a particle, by axis.
struct Particles {
  std::array<std::vector<double>, 3> x;                     ///< places [length]
  std::array<std::vector<double>, 3> v;                     ///< velocities
  std::array<std::array<std::vector<double>, 3>, 3> slope;  ///< [a][b]: of v[a] along b [velocity/length]
  std::vector<double> volume;

  std::size_t size() const { return volume.size(); }
  /// Adds one whose velocity is the same all about it.
  void add(int dim, const Vec<3>& place, const Vec<3>& velocity, double of_volume);
};

/// Calls f(name, list) for all lists. In the plane those along z are empty.
template <class Function>
void each_list(Particles& particles, const Function& f) {
  constexpr std::array axes{"x", "y", "z"};
  for (std::size_t a = 0; a < 3; ++a) {
    f(std::string("particle_") + axes[a], particles.x[a]), f(std::string("particle_v_") + axes[a], particles.v[a]);
    for (std::size_t b = 0; b < 3; ++b) f(std::string("particle_slope_") + axes[a] + axes[b], particles.slope[a][b]);
  }
  f(std::string("particle_volume"), particles.volume);
}

/// The cell that a place is in; places beyond the box belong to the cell next to them.
inline std::array<int, 3> cell_of(const StaggeredGrid& grid, const Vec<3>& x) {
  std::array<int, 3> cell{};
  for (std::size_t a = 0; a < static_cast<std::size_t>(grid.dim); ++a)
    cell[a] = std::clamp(static_cast<int>((x[a] - grid.low[a]) / grid.d[a]), 0, grid.n[a] - 1);
  return cell;
}

/// A particle's place; z is 0 in the plane.
inline Vec<3> place_of(const Particles& particles, int dim, std::size_t k) {
  return {particles.x[0][k], particles.x[1][k], dim == 3 ? particles.x[2][k] : 0};
}

/// Returns the same in so many dimensions.
template <std::size_t dim>
std::array<double, dim> place_of(const Particles& particles, std::size_t k) {
  std::array<double, dim> x;
  for (std::size_t b = 0; b < dim; ++b) x[b] = particles.x[b][k];
  return x;
}

/// Which particles each cell has, once they are sorted: from first[c] to before first[c + 1].
struct CellParticles {
  std::vector<std::size_t> first;
};

/// Sorts the particles by their cells; in a cell they keep their order.
CellParticles sort_by_cells(Team& team, const StaggeredGrid& grid, Particles& particles);

/// Calls f(first particle, the one after the last) for slabs of cells along the last axis, so that no two that run at
/// once have a cell within two of each other: each may add to what lies about its own cells. Sums are the same for any
/// number of threads.
template <class Function>
void each_slab(Team& team, const StaggeredGrid& grid, const CellParticles& cells, const Function& f) {
  constexpr std::size_t layers = 4;  // of a slab
  const std::size_t along = grid.dim == 3 ? 2 : 1, count = static_cast<std::size_t>(grid.n[along]),
                    of_layer = grid.cell_count() / count, slabs = (count + layers - 1) / layers;
  for (const std::size_t odd : {std::size_t{0}, std::size_t{1}}) {
    team.each(0, (slabs + 1 - odd) / 2, [&](std::size_t k) {
      const std::size_t slab = 2 * k + odd;
      f(cells.first[slab * layers * of_layer], cells.first[std::min(count, (slab + 1) * layers) * of_layer]);
    });
  }
}

}  // namespace tether::liquid
