// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "grid/figures.hpp"
#include "grid/solid_surface.hpp"
#include "model/coupled.hpp"
#include "physics/box/surface_pieces.hpp"

namespace tether::coupled {

/// Adds a figure's surface to another one as a sheet and a part of its own, and its nodes to `x`, where `first` numbers
/// are before these.
void add_figure(const FigureSurface& figure, std::size_t first, std::vector<double>& x, SolidSurface& surface);

/// The surface of bodies together with that of obstacles that cut cells: these are the last sheets and parts of it, and
/// have nodes of their own after those of the bodies, which never move. Without such obstacles it is the bodies' alone.
class WholeSurface {
 public:
  /// The bodies have so many numbers of places.
  WholeSurface(const Coupled& scene, const SolidSurface& bodies, std::size_t places);

  const SolidSurface& surface() const { return surface_; }
  /// Returns whether there are obstacles in it.
  bool has_obstacles() const { return !fixed_.empty(); }
  /// Places of all nodes, with the bodies' at q.
  std::vector<double> places(std::span<const double> q) const;
  /// Adds the obstacles' pieces, cut by two boxes a cell, to those of the bodies.
  void add_obstacles(SurfacePieces& pieces) const;
  /// Returns whether an obstacle has the middle of a cell.
  bool in_obstacle(std::size_t cell) const { return has_obstacles() && inside_[cell] != 0; }

 private:
  SolidSurface surface_;
  std::vector<double> fixed_;  // places of the obstacles' nodes
  SurfacePieces pieces_;       // of the obstacles
  std::vector<std::uint8_t> inside_;
};

}  // namespace tether::coupled
