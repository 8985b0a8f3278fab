// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/obstacles.hpp"

#include <algorithm>

#include "base/numbers.hpp"
#include "grid/crossings.hpp"

namespace tether::coupled {
namespace {

Box<3> box_of(const StaggeredGrid& grid) {
  Box<3> box;
  for (int axis = 0; axis < 3; ++axis) box.low[at(axis)] = grid.low[at(axis)], box.high[at(axis)] = grid.high(axis);
  return box;
}

/// Adds a figure as a sheet and a part of its own.
void add(const FigureSurface& figure, std::vector<double>& places, SolidSurface& surface) {
  const int first = static_cast<int>(places.size()) / surface.dim;
  places.insert(places.end(), figure.x.begin(), figure.x.end());
  for (const int node : figure.sides) surface.sides.push_back(first + node);
  surface.sheet.resize(surface.sides.size() / at(surface.dim), surface.sheets++);
  surface.part.resize(surface.sheet.size(), surface.parts++);
  surface.cavity.push_back(0);
}

}  // namespace

WholeSurface::WholeSurface(const Coupled& scene, const SolidSurface& bodies, std::size_t places) : surface_(bodies) {
  if (scene.shaped.empty()) return;
  const StaggeredGrid& grid = scene.grid;
  const double cell = *std::min_element(grid.d.begin(), grid.d.begin() + grid.dim);
  SolidSurface alone;
  alone.dim = grid.dim;
  for (const Obstacle& obstacle : scene.shaped)
    add(surface_of(obstacle.figure, grid.dim, box_of(grid), cell), fixed_, alone);
  pieces_ = cut_surface(alone, fixed_, grid, 2);
  inside_ = find_crossings(alone, fixed_, grid).inside;
  std::vector<double> all(places, 0.0);
  for (const Obstacle& obstacle : scene.shaped)
    add(surface_of(obstacle.figure, grid.dim, box_of(grid), cell), all, surface_);
}

std::vector<double> WholeSurface::places(std::span<const double> q) const {
  std::vector<double> places(q.begin(), q.end());
  places.insert(places.end(), fixed_.begin(), fixed_.end());
  return places;
}

void WholeSurface::add_obstacles(SurfacePieces& pieces) const {
  const std::size_t sides = pieces.area.size(), points = pieces.points.size();
  for (SurfacePiece piece : pieces_.pieces) {
    piece.side += static_cast<int>(sides), piece.first += points;
    pieces.pieces.push_back(piece);
  }
  pieces.points.insert(pieces.points.end(), pieces_.points.begin(), pieces_.points.end());
  pieces.area.insert(pieces.area.end(), pieces_.area.begin(), pieces_.area.end());
}

}  // namespace tether::coupled
