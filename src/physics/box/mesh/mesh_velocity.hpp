// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "model/coupled.hpp"
#include "physics/box/mesh/flow_mesh.hpp"
#include "physics/box/outside.hpp"

namespace tether::coupled {

/// Finds the cell that a place is in.
class CellFinder {
 public:
  /// The mesh must outlive it.
  explicit CellFinder(const FlowMesh& mesh);

  /// The cell that has a place, or the nearest one about it where none has: then the place is moved into it.
  std::size_t cell_at(Vec<3>& x) const;
  /// Goes from a cell on the straight way to a place, to the cell that has it, or as far as the boundary lets it: then
  /// the place is moved there, and `face` is that of the boundary; else it is -1.
  std::size_t walk(std::size_t cell, Vec<3>& x, int& face) const;

 private:
  std::array<int, 3> bin_of(const Vec<3>& x) const;
  std::size_t number(const std::array<int, 3>& bin) const;

  const FlowMesh& mesh_;
  Vec<3> low_{};
  double width_ = 1;
  std::array<int, 3> n_{1, 1, 1};
  std::vector<std::size_t> first_, cell_;  // cells that reach into each bin
};

/// The velocity of a fluid on a mesh at any place: that of each cell, with the gradient that the means about its nodes
/// have. Cells at a boundary stay within the extrema of both: they may be those of a film.
class MeshVelocity {
 public:
  /// `v` has, along each axis, a number for each cell. Both must outlive it.
  MeshVelocity(const FlowMesh& mesh, const FaceValues& v);

  Vec<3> velocity(std::size_t cell, const Vec<3>& x) const;
  /// Where what is at a place now was a time before.
  struct Origin {
    Vec<3> x;
    std::size_t cell = 0;
    int face = -1;       ///< of the boundary that it came in through
    int opened_at = -1;  ///< where a solid was at the place, which was in no cell: the nearest one
  };
  /// Finds it by the mid-point rule.
  Origin before(const Vec<3>& x, double h) const;
  const CellFinder& finder() const { return finder_; }

 private:
  const FlowMesh& mesh_;
  const FaceValues& v_;
  CellFinder finder_;
  std::array<std::vector<double>, 3> mean_;                  // about each node, by axis [velocity]
  std::array<std::array<std::vector<double>, 3>, 3> slope_;  // [a][b]: of v_a along b, of each cell [1/time]
};

}  // namespace tether::coupled
