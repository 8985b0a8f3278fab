// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/obstacles.hpp"

#include <algorithm>

#include "base/numbers.hpp"
#include "grid/crossings.hpp"

namespace tether::coupled {

void add_figure(const FigureSurface& figure, std::size_t first, std::vector<double>& x, SolidSurface& surface) {
  const int node = static_cast<int>((first + x.size()) / at(surface.dim));
  x.insert(x.end(), figure.x.begin(), figure.x.end());
  for (const int of_figure : figure.sides) surface.sides.push_back(node + of_figure);
  surface.sheet.resize(surface.sides.size() / at(surface.dim), surface.sheets++);
  surface.part.resize(surface.sheet.size(), surface.parts++);
  surface.cavity.push_back(0);
}

WholeSurface::WholeSurface(const Coupled& scene, const SolidSurface& bodies, std::size_t places) : surface_(bodies) {
  if (scene.shaped.empty()) return;
  const StaggeredGrid& grid = scene.grid;
  const double cell = *std::min_element(grid.d.begin(), grid.d.begin() + grid.dim);
  SolidSurface alone;
  alone.dim = grid.dim;
  std::vector<double> same;
  for (const Obstacle& obstacle : scene.shaped) {
    const FigureSurface figure = surface_of(obstacle.figure, grid.dim, grid.box(), cell);
    add_figure(figure, 0, fixed_, alone);
    add_figure(figure, places, same, surface_);
  }
  pieces_ = cut_surface(alone, fixed_, grid, 2);
  inside_ = find_crossings(alone, fixed_, grid).inside;
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
