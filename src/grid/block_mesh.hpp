// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "base/vec.hpp"
#include "grid/mesh.hpp"
#include "grid/mesh_flaws.hpp"

namespace tether {

/// Returns for each node the lowest number of a node at its place, to 1e-9 of the mesh's size.
std::vector<int> lowest_at_place(const Mesh& mesh);

/// Nodes at one place, to 1e-9 of the mesh's size, become one, with the lowest of their numbers; the others follow in
/// their order. Returns the new number of each node. Sides that are there already are not renumbered.
std::vector<int> join_nodes(Mesh& mesh);

/// A place on one of a block's four edges, at the part `s` (0 .. 1) of its length.
using EdgeCurve = std::function<Vec<2>(double s)>;

/// One mapped quadrilateral, and in space what it sweeps from z_low to z_high. Edge k runs from corner k to corner k +
/// 1; corners counter-clockwise. `first` cells lie along edges 0 and 2, `second` along edges 1 and 3.
struct Block {
  std::array<EdgeCurve, 4> edges;
  std::array<int, 3> cells{1, 1, 1};
  std::array<double, 3> grading{1, 1, 1};  ///< last cell over first along edge 0, edge 1 and z
  /// Middle cells over those at both ends along the same, in place of `grading` where it is not 1.
  std::array<double, 3> grading_middle{1, 1, 1};
  double z_low = 0, z_high = 0;
  /// Names of the sides on edges 0 to 3 and at z_low and z_high; none is "".
  std::array<std::string, 6> names;
  int number = 0;  ///< of the block in the names of its sides and in flaws; 0: its place in the list, from 1
};

/// Straight line between two corners.
EdgeCurve straight(Vec<2> from, Vec<2> to);
/// Part of an ellipse (of a circle where a = b) about `centre` with half axes a, b, whose parameter's angle runs from
/// that of `from` to that of `to` the shorter way. [length]
EdgeCurve elliptic(Vec<2> from, Vec<2> to, Vec<2> centre, double a, double b);

/// The mesh of blocks 0, 1, ...: nodes by transfinite interpolation between the edges, those of different blocks that
/// coincide are one. Each side has the name that its block gives it and `<block's number>.bottom`, `.right`, `.top`,
/// `.left` (edges 0 to 3), `.back`, `.front` (z_low, z_high), where it is not shared. Flaws, of which there must be
/// none for the mesh to be used: an inverted element, a node of one block on a side of another that does not have it.
Mesh mesh_of_blocks(const std::vector<Block>& blocks, ElementKind kind, std::vector<MeshFlaw>& flaws);
/// The number of block b, from 0, in such names.
int number_of(const std::vector<Block>& blocks, std::size_t b);

}  // namespace tether
