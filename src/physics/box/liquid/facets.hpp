// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "base/vec.hpp"
#include "physics/box/liquid/surface.hpp"

namespace tether::liquid {

/// A triangle in the plane, a tetrahedron in space, whose corners' distances from the surface are known.
struct Simplex {
  std::array<Vec<3>, 4> corner{};
  std::array<double, 4> distance{};
  double open = 0;  ///< part of it that no solid has, about
};

/// A piece of the surface: an edge in the plane, a triangle in space, the liquid to the left of an edge, and below a
/// triangle whose corners turn counter-clockwise as seen from above.
using Facet = std::array<Vec<3>, 3>;

/// What the surface makes of a simplex.
struct Cut {
  double volume = 0;  ///< of its part in the liquid
  std::array<Facet, 2> facet{};
  std::size_t facets = 0;
};
Cut cut_of(const Simplex& simplex, int dim);

/// Area of a facet, per unit depth in the plane.
double area_of(const Facet& facet, int dim);

/// Calls f(simplex) for simplices that fill the box: between the middles of cells, and from these to the box's sides,
/// where the distance is that of the cell beside.
template <class Function>
void each_simplex(const Surface& surface, const Function& f) {
  constexpr std::array<std::array<std::size_t, 3>, 6> orders{
      {{0, 1, 2}, {1, 0, 2}, {0, 2, 1}, {2, 0, 1}, {1, 2, 0}, {2, 1, 0}}};  // of axes, the first two of the plane
  const StaggeredGrid& grid = surface.room.grid;
  const auto dim = static_cast<std::size_t>(grid.dim);
  const auto add = [&](const std::array<int, 3>& point, std::size_t k, Simplex& to) {
    std::array<int, 3> cell{};
    for (std::size_t a = 0; a < dim; ++a) {
      cell[a] = std::clamp(point[a] - 1, 0, grid.n[a] - 1);
      const int axis = static_cast<int>(a);
      to.corner[k][a] = point[a] == 0               ? grid.low[a]
                        : point[a] == grid.n[a] + 1 ? grid.high(axis)
                                                    : grid.middle(axis, point[a] - 1);
    }
    to.distance[k] = surface.distance[grid.cell(cell)];
    to.open += surface.open[grid.cell(cell)] / static_cast<double>(dim + 1);
  };
  std::array<int, 3> first{}, last{0, 0, 0};
  for (std::size_t a = 0; a < dim; ++a) last[a] = grid.n[a];
  for (first[2] = 0; first[2] <= last[2]; ++first[2]) {
    for (first[1] = 0; first[1] <= last[1]; ++first[1]) {
      for (first[0] = 0; first[0] <= last[0]; ++first[0]) {
        for (std::size_t o = 0; o < (dim == 2 ? 2 : 6); ++o) {
          Simplex simplex;
          std::array<int, 3> point = first;
          add(point, 0, simplex);
          for (std::size_t k = 0; k < dim; ++k) {
            ++point[orders[o][k]];
            add(point, k + 1, simplex);
          }
          f(simplex);
        }
      }
    }
  }
}

}  // namespace tether::liquid
