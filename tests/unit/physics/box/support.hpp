// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "physics/box/friction/viscosity.hpp"
#include "physics/box/outside.hpp"

namespace tether::coupled::support {

inline StaggeredGrid unit_box(int dim, int n) {
  StaggeredGrid grid;
  grid.dim = dim;
  for (std::size_t a = 0; a < 3; ++a) grid.n[a] = static_cast<int>(a) < dim ? n : 1;
  for (std::size_t a = 0; a < static_cast<std::size_t>(dim); ++a) grid.d[a] = 1.0 / n;
  return grid;
}

inline std::array<double, 3> middle_of_face(const StaggeredGrid& grid, int axis, std::size_t face) {
  const auto f = grid.place_of_face(axis, face);
  std::array<double, 3> x{};
  for (int b = 0; b < grid.dim; ++b) {
    const int i = f[static_cast<std::size_t>(b)];
    x[static_cast<std::size_t>(b)] = b == axis ? grid.face_place(b, i) : grid.middle(b, i);
  }
  return x;
}

inline bool on_side(const StaggeredGrid& grid, int axis, std::size_t face) {
  const int i = grid.place_of_face(axis, face)[static_cast<std::size_t>(axis)];
  return i == 0 || i == grid.n[static_cast<std::size_t>(axis)];
}

/// All fluid; the sides are walls or open.
inline FlowDomain box(const StaggeredGrid& grid, FaceKind sides = FaceKind::prescribed) {
  FlowDomain domain{grid, {}, {}, face_values(grid), face_values(grid), {}, 1};
  domain.kind.assign(grid.cell_count(), CellKind::fluid);
  domain.region.assign(grid.cell_count(), 0);
  for (int axis = 0; axis < grid.dim; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    for (std::size_t f = 0; f < grid.face_count(axis); ++f) {
      domain.face[a].push_back(on_side(grid, axis, f) ? sides : FaceKind::open);
      domain.area[a][f] = grid.area(axis);
      domain.volume[a][f] = grid.volume() * (on_side(grid, axis, f) ? 0.5 : 1);
    }
  }
  return domain;
}

inline void close_face(FlowDomain& domain, int axis, const std::array<int, 3>& place) {
  const std::size_t f = domain.grid.face(axis, place);
  domain.face[static_cast<std::size_t>(axis)][f] = FaceKind::closed;
  domain.area[static_cast<std::size_t>(axis)][f] = 0;
  domain.volume[static_cast<std::size_t>(axis)][f] = 0;
}

/// Fills a cell with a solid, which closes its faces, or with a wall, which prescribes them.
inline void fill_cell(FlowDomain& domain, const std::array<int, 3>& cell, CellKind kind = CellKind::solid) {
  domain.kind[domain.grid.cell(cell)] = kind;
  for (int axis = 0; axis < domain.grid.dim; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    auto upper = cell;
    ++upper[a];
    for (const auto& place : {cell, upper}) {
      if (kind == CellKind::solid) close_face(domain, axis, place);
      if (kind == CellKind::wall) domain.face[a][domain.grid.face(axis, place)] = FaceKind::prescribed;
    }
  }
}

/// Each face's component of a velocity that is a function of the place.
template <class Velocity>
FaceValues faces_of(const StaggeredGrid& grid, const Velocity& velocity) {
  FaceValues v = face_values(grid);
  for (int axis = 0; axis < grid.dim; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    for (std::size_t f = 0; f < v[a].size(); ++f) v[a][f] = velocity(middle_of_face(grid, axis, f))[a];
  }
  return v;
}

/// Mean over the open faces of the distance between two fields.
inline double mean_distance(const FlowDomain& domain, const FaceValues& v, const FaceValues& w) {
  double sum = 0;
  int count = 0;
  for (std::size_t a = 0; a < static_cast<std::size_t>(domain.grid.dim); ++a) {
    for (std::size_t f = 0; f < v[a].size(); ++f) {
      if (domain.face[a][f] == FaceKind::open) sum += std::abs(v[a][f] - w[a][f]), ++count;
    }
  }
  return sum / count;
}

inline double largest_distance(const FlowDomain& domain, const FaceValues& v, const FaceValues& w) {
  double largest = 0;
  for (std::size_t a = 0; a < static_cast<std::size_t>(domain.grid.dim); ++a) {
    for (std::size_t f = 0; f < v[a].size(); ++f) {
      if (domain.face[a][f] == FaceKind::open) largest = std::max(largest, std::abs(v[a][f] - w[a][f]));
    }
  }
  return largest;
}

/// Of a fluid that fills all cells.
inline const CellParts all_liquid;

/// A whirl in the unit box that is at rest at its sides and, where the box has a depth, has no part across it.
inline std::array<double, 3> whirl(const std::array<double, 3>& x) {
  const double pi = std::numbers::pi, sx = std::sin(pi * x[0]), sy = std::sin(pi * x[1]);
  return {sx * sx * std::sin(2 * pi * x[1]), -sy * sy * std::sin(2 * pi * x[0]), 0};
}

/// Where what this whirl carries to x was a time before, by Runge and Kutta's fourth order in so many steps.
inline std::array<double, 3> origin(std::array<double, 3> x, double time, int steps) {
  using Place = std::array<double, 3>;
  const double k = -time / steps;
  const auto moved = [&](const Place& u, double by) { return Place{x[0] + by * u[0], x[1] + by * u[1], x[2]}; };
  for (int i = 0; i < steps; ++i) {
    const Place a = whirl(x), b = whirl(moved(a, k / 2)), c = whirl(moved(b, k / 2)), e = whirl(moved(c, k));
    for (std::size_t q = 0; q < 2; ++q) x[q] += k / 6 * (a[q] + 2 * b[q] + 2 * c[q] + e[q]);
  }
  return x;
}

}  // namespace tether::coupled::support
