// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/liquid/speed_limit.hpp"

#include <cmath>

#include "base/blocks.hpp"
#include "base/numbers.hpp"

namespace tether::liquid {
namespace {

/// Gives each cell the largest value of the cells about it, corners included.
void take_largest_about(const StaggeredGrid& grid, std::vector<double>& values) {
  for (int axis = 0; axis < grid.dim; ++axis) {
    const std::vector<double> before = values;
    const std::size_t stride = grid.stride(axis);
    for (std::size_t c = 0; c < values.size(); ++c) {
      const int i = static_cast<int>(c / stride % at(grid.n[at(axis)]));
      if (i > 0) values[c] = std::max(values[c], before[c - stride]);
      if (i + 1 < grid.n[at(axis)]) values[c] = std::max(values[c], before[c + stride]);
    }
  }
}

}  // namespace

std::vector<double> fastest_about(const StaggeredGrid& grid, const coupled::FaceValues& v) {
  std::vector<double> fastest(grid.cell_count(), 0.0);
  for (std::size_t c = 0; c < fastest.size(); ++c) {
    const auto place = grid.place_of_cell(c);
    for (int axis = 0; axis < grid.dim; ++axis) {
      auto upper = place;
      ++upper[at(axis)];
      const double most =
          std::max(std::abs(v[at(axis)][grid.face(axis, place)]), std::abs(v[at(axis)][grid.face(axis, upper)]));
      fastest[c] += most * most;
    }
    fastest[c] = std::sqrt(fastest[c]);
  }
  take_largest_about(grid, fastest);
  return fastest;
}

void limit_thin_pieces(Team& team, const StaggeredGrid& grid, std::span<const double> distance,
                       std::span<const double> fastest, double more, Particles& particles) {
  constexpr double deep = 1;  // cells from the surface
  std::vector<double> depth;
  for (const double d : distance) depth.push_back(-d);
  take_largest_about(grid, depth);
  each_block(team, particles.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const std::size_t c = grid.cell(cell_of(grid, place_of(particles, grid.dim, k)));
      if (depth[c] >= deep) continue;
      double square = 0;
      for (std::size_t a = 0; a < at(grid.dim); ++a) square += particles.v[a][k] * particles.v[a][k];
      const double most = fastest[c] + more;
      if (square <= most * most) continue;
      const double part = most / std::sqrt(square);
      for (std::size_t a = 0; a < at(grid.dim); ++a) {
        particles.v[a][k] *= part;
        for (std::size_t b = 0; b < at(grid.dim); ++b) particles.slope[a][b][k] *= part;
      }
    }
  });
}

}  // namespace tether::liquid
