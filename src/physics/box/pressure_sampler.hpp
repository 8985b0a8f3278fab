// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/team.hpp"
#include "physics/box/cut_cells.hpp"
#include "physics/box/outside.hpp"
#include "physics/box/surface_pieces.hpp"

namespace tether::coupled {

/// A pressure as a sum over fluid cells. Void ones count with their weight, but their pressure is zero.
struct PressureStencil {
  std::array<std::size_t, 4> cell{};
  std::array<double, 4> weight{};
  std::size_t size = 0;
  void add(std::size_t c, double w) {
    cell[size] = c, weight[size] = w;
    ++size;
  }
};

/// The fluid's pressure on the solids' surface, from the side that a surface faces.
class PressureSampler {
 public:
  PressureSampler(const SolidSurface& surface, std::span<const double> q, const SurfacePieces& pieces,
                  const FlowDomain& domain);

  /// The nearest cell of fluid or void that the piece faces and that no other surface hides from it; -1 where there is
  /// none.
  int cell_before(const SurfacePiece& piece) const;
  /// The pressure at x from that cell and its neighbours: linear towards neighbours that open faces join, half of what
  /// a linear one would change where x lies on the other side of the cell. B takes it twice, for the force and for the
  /// flux: by halves the strip between the cell's middle and the surface weighs what it should, to second order. In a
  /// film there is no such strip: `behind` 1 takes all of what a linear one would change.
  PressureStencil at(const Vec<3>& x, std::size_t cell, double behind = 0.5) const;
  /// Returns whether no other side of the surface is between a piece and a place.
  bool sees(const SurfacePiece& piece, const Vec<3>& to) const;
  /// Returns the places of the solids' nodes.
  std::span<const double> places() const { return q_; }

 private:
  int nearest(const SurfacePiece& piece, const std::array<int, 3>& middle, int reach) const;
  bool is_hidden_by(int side, const Vec<3>& from, const Vec<3>& to) const;
  /// The neighbour along an axis, in the direction of `end`, that an open face joins; -1 where there is none.
  int joined(const std::array<int, 3>& cell, int axis, int end) const;

  const SolidSurface& surface_;
  std::span<const double> q_;
  const SurfacePieces& pieces_;
  const FlowDomain& domain_;
  std::vector<int> first_, sides_;  // of each cell of the grid the sides in it: sides_[first_[c]] ...
};

/// Returns for each piece of the surface the open side of the box straight before it, nearer than half a cell and than
/// the middle of the cell before it (`before`, as the sampler finds it); -1: none. The last cell's middle is beyond
/// such a piece, and yet it has no film: what it pushes goes out through the side, whose pressure it feels. Pieces in a
/// side count as before it, those beyond do not.
std::vector<int> open_sides_before(Team& team, const SurfacePieces& pieces, const FlowDomain& domain,
                                   const PressureSampler& sampler, std::span<const int> before);

}  // namespace tether::coupled
