// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "grid/crossings.hpp"
#include "model/coupled.hpp"
#include "physics/box/coupling_map.hpp"
#include "physics/box/cut_cells.hpp"
#include "physics/box/flow_box.hpp"
#include "physics/box/friction/near_surface.hpp"
#include "physics/box/liquid/surface.hpp"
#include "physics/box/obstacles.hpp"
#include "physics/box/outside.hpp"

namespace tether::coupled {

/// Where the solids are, and the room that they leave in the box.
struct Room {
  std::vector<double> places;  ///< of the nodes of bodies and obstacles, to which crossings belong [length]
  SurfacePieces pieces;        ///< of the bodies
  SurfacePieces all;           ///< of bodies and obstacles; empty where no obstacle cuts cells
  Crossings crossings;
  CutCells cells;  ///< of modes that cut faces
  FlowDomain domain;
  std::vector<double> open;  ///< of each cell, for a liquid: liquid::open_parts()

  const SurfacePieces& all_pieces() const { return all.area.empty() ? pieces : all; }
};

/// Where the solids are and what that makes of the fluid: what a step begins with.
struct Placement {
  std::vector<SurfacePiece> pieces;  ///< of the surface
  std::vector<std::uint8_t> thin;    ///< cells where a solid is thinner than a cell, of modes that cut faces
  FlowDomain domain;
  std::optional<liquid::Surface> surface;  ///< of a liquid, which leaves part of its room empty
  PressureNumbers numbers;
  CouplingMap map;
  CouplingMatrix crossing_map;  ///< of the paper's own mode
  SurfaceNearFaces near_faces;  ///< of a fluid that rubs

  /// Returns what solids leave, liquid or not.
  const FlowDomain& room() const { return surface ? surface->room : domain; }
};

/// Places solids in the box. All of its arguments must outlive it.
class Placer {
 public:
  /// The surface is that of bodies that have so many numbers of places.
  Placer(const Coupled& scene, const SolidSurface& surface, std::size_t places, const FlowBox& box,
         const Outside& outside, Team& team)
      : team_(team), scene_(scene), surface_(surface), whole_(scene, surface, places), box_(box), outside_(outside) {}

  /// The surface of bodies and of obstacles that cut cells.
  const WholeSurface& whole() const { return whole_; }

  /// Places the solids with their nodes at q. `filled`: how much of each cell a liquid fills; empty: what flows is all
  /// over the room.
  Placement at(std::span<const double> q, std::span<const double> filled = {}) const;

  /// Does the same in two steps, for who looks at the room first.
  Room room_at(std::span<const double> q) const;
  Placement in(Room room, std::span<const double> q, std::span<const double> filled) const;

 private:
  void map(std::span<const double> q, const Room& room, Placement& at) const;

  Team& team_;
  const Coupled& scene_;
  const SolidSurface& surface_;
  WholeSurface whole_;
  const FlowBox& box_;
  const Outside& outside_;
};

}  // namespace tether::coupled
