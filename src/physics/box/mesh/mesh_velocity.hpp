// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "base/numbers.hpp"
#include "physics/box/mesh/cell_field.hpp"
#include "physics/box/mesh/flow_at_nodes.hpp"

namespace tether::coupled {

/// Finds the cell that a place is in.
class CellFinder {
 public:
  /// The mesh must outlive it.
  explicit CellFinder(const FlowMesh& mesh);

  /// The cell that has a place, or the nearest one about it where none has: then the place is moved into it.
  std::size_t cell_at(Vec<3>& x) const;
  /// Finds it likewise, looking first along the straight way from a cell near the place.
  std::size_t cell_at(Vec<3>& x, std::size_t near) const;
  /// Goes from a cell on the straight way to a place, to the cell that has it, or as far as the boundary lets it: then
  /// the place is moved there, and `face` is that of the boundary; else it is -1.
  std::size_t walk(std::size_t cell, Vec<3>& x, int& face) const;

 private:
  std::size_t nearest_to(Vec<3>& x) const;
  std::array<int, 3> bin_of(const Vec<3>& x) const;
  std::size_t number(const std::array<int, 3>& bin) const;

  const FlowMesh& mesh_;
  Vec<3> low_{};
  double width_ = 1;
  std::array<int, 3> n_{1, 1, 1};
  std::vector<std::size_t> first_, cell_;  // cells that reach into each bin
};

/// The velocity of a fluid on a mesh at any place. In the plane it is the mean of the flows at a cell's nodes by the
/// place's shares, each followed half the way: the same from both sides of a face, and exact where it is a quadratic
/// one. In cells that have nodes at a boundary, and in space, it is that of the cell, with the gradient that the means
/// about its nodes have: at a boundary within the extrema of both, for the cell may be one of a film.
class MeshVelocity {
 public:
  /// `v` has, along each axis, a number for each cell, and is free of divergence. Both must outlive it.
  MeshVelocity(const FlowMesh& mesh, const FaceValues& v);

  Vec<3> velocity(std::size_t cell, const Vec<3>& x) const;
  /// Where what is at a place now was a time before.
  struct Origin {
    Vec<3> x;
    std::size_t cell = 0, from = 0;  ///< cells of that place, and of the place now
    double part = 1;                 ///< of what the latter has more than the velocity there that is lost
    int face = -1;                   ///< of the boundary that it came in through
    int opened_at = -1;              ///< where a solid was at the place, which was in no cell: the nearest one
  };
  /// Finds it by the mid-point rule. `near` is a cell near x.
  Origin before(const Vec<3>& x, double h, std::size_t near) const;
  /// Returns v, which comes from there to x, with what stays at x.
  Vec<3> with_rest(const Origin& origin, const Vec<3>& x, Vec<3> v) const;
  /// Finds it by the means about the nodes of the cell alone: smoother than the flow is, and within their extrema.
  Vec<3> smooth_velocity(std::size_t cell, const Vec<3>& x) const;
  const CellFinder& finder() const { return finder_; }

 private:
  bool is_at_boundary(std::size_t cell) const;
  double part_lost(std::size_t cell, const Vec<3>& x, const Vec<3>& origin) const;
  Vec<3> by_nodes(std::size_t cell, const Vec<3>& x) const;
  Vec<3> by_cell(std::size_t cell, const Vec<3>& x) const;

  const FlowMesh& mesh_;
  CellFinder finder_;
  std::vector<FlowAtNode> at_node_;        // in the plane
  std::vector<std::uint8_t> at_boundary_;  // of each node
  std::vector<CellField> along_;           // each axis [velocity]
};

/// Share of a cell's own node in each place within it; the other nodes have the rest.
constexpr double share_of_place(int dim) { return dim == 2 ? 2.0 / 3 : 0.58541019662496845446; }

/// Calls f(cell, x) for three places within each triangle, or four within each tetrahedron, whose mean is that of the
/// cell for squares. Places on faces would not do: a cell at the end of a film has the film's velocity there, which is
/// that of next to nothing.
template <class Function>
void each_place_within(const FlowMesh& mesh, const Function& f) {
  const double near = share_of_place(mesh.dim), far = (1 - near) / mesh.dim;
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
    const auto nodes = mesh.nodes_of(cell);
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      Vec<3> x{};
      for (std::size_t n = 0; n < nodes.size(); ++n) {
        for (std::size_t a = 0; a < 3; ++a) x[a] += (n == k ? near : far) * mesh.x[at(nodes[n])][a];
      }
      f(cell, x);
    }
  }
}

/// What a step brings to the cells of a mesh.
struct Carried {
  FaceValues v;       ///< velocity
  FaceValues smooth;  ///< by means about nodes alone, which loses more
};

/// Finds for each cell of a mesh the mean of what comes there in a time h. `met(origin, v)` returns the velocity of
/// what comes from there, where the fluid has v.
///
/// What cells have more than the velocity at their places stays there, less what is lost of it by the way, or where a
/// cell is not the same as before: a fluid that hardly moves in a step keeps its velocity, whatever a cell's
/// velocities are made of, and short steps lose no more in a time than long ones. With it velocities keep within what
/// both ends of the way have.
template <class Met>
void carry_to(const FlowMesh& mesh, const MeshVelocity& from, double h, const Met& met, Carried& to) {
  const double part = 1 / static_cast<double>(mesh.corners());
  std::size_t near = 0;
  each_place_within(mesh, [&](std::size_t cell, const Vec<3>& x) {
    const MeshVelocity::Origin origin = from.before(x, h, near);
    near = origin.from;
    const Vec<3> smooth = met(origin, from.smooth_velocity(origin.cell, origin.x));
    Vec<3> v = met(origin, from.velocity(origin.cell, origin.x));
    if (origin.part < 1) v = from.with_rest(origin, x, v);
    for (std::size_t a = 0; a < at(mesh.dim); ++a) to.v[a][cell] += part * v[a], to.smooth[a][cell] += part * smooth[a];
  });
}

/// Moves what is carried towards what is smooth, by the least part that leaves no more than `most` of the sum over
/// cells of v . v times volume; wholly where none does.
void hold_energy(const FlowMesh& mesh, double most, Carried& carried);

}  // namespace tether::coupled
