// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vec.hpp"

namespace tether::coupled {

/// What a face at the fluid's boundary lies on; `closed` is the end of a film that is too thin to hold fluid.
enum class BoundaryKind { none, box_side, solid, obstacle, closed };

/// That, and which side of the box or of the surface.
struct Boundary {
  BoundaryKind kind = BoundaryKind::none;
  int number = -1;
};

/// A fluid's triangles or tetrahedra, and the faces between them. In the plane volumes and areas are per unit depth.
struct FlowMesh {
  int dim = 2;
  std::vector<Vec<3>> x;   ///< of each node [length]
  std::vector<int> nodes;  ///< dim + 1 of each cell

  // What find_faces() makes of these.
  std::vector<int> face;                          ///< dim + 1 of each cell, each opposite to its node
  std::vector<int> nodes_of_face;                 ///< dim of each face
  std::vector<std::array<int, 2>> cells_of_face;  ///< cells of each face; the second one -1 at the boundary
  std::vector<Vec<3>> area;                       ///< of each face, times its normal out of the first cell [area]
  std::vector<double> volume;                     ///< of each cell [volume]
  std::vector<Vec<3>> cell_middle;                ///< of each cell
  std::vector<Vec<3>> share_slope;                ///< of the share of each node of each cell, by length
  std::vector<Boundary> boundary;                 ///< of each face, for the mesher to set
  std::vector<int> region;                        ///< of each cell, from 0: cells that faces join
  int regions = 0;

  std::size_t cells() const { return nodes.size() / corners(); }
  std::size_t faces() const { return cells_of_face.size(); }
  std::size_t corners() const { return static_cast<std::size_t>(dim) + 1; }
  std::span<const int> nodes_of(std::size_t cell) const {
    return std::span(nodes).subspan(cell * corners(), corners());
  }
  std::span<const int> faces_of(std::size_t cell) const { return std::span(face).subspan(cell * corners(), corners()); }
  std::span<const int> face_nodes(std::size_t f) const {
    return std::span(nodes_of_face).subspan(f * static_cast<std::size_t>(dim), static_cast<std::size_t>(dim));
  }
  bool is_at_boundary(std::size_t f) const { return cells_of_face[f][1] < 0; }
  /// The cell of a face, the first one where it has two.
  std::size_t cell_of(std::size_t f) const { return static_cast<std::size_t>(cells_of_face[f][0]); }
  double size_of(std::size_t f) const { return std::sqrt(dot(area[f], area[f])); }
  double largest_face(std::size_t cell) const {
    double largest = 0;
    for (const int f : faces_of(cell)) largest = std::max(largest, size_of(static_cast<std::size_t>(f)));
    return largest;
  }
  /// Marks the faces of flat cells, as in films.
  std::vector<std::uint8_t> faces_of_flat_cells() const;
  /// Cells at a boundary whose other node is at one that looks the other way: alone they fill a gap, which is wider
  /// than `least` [length].
  std::vector<std::size_t> cells_across_gaps(double least) const;
  /// The volume of each part, where each cell has the number of its own, or -1.
  std::vector<double> volumes_of(std::span<const int> part, int count) const;
  /// Marks the nodes of faces at the boundary.
  std::vector<std::uint8_t> nodes_at_boundary() const;
  /// The cells that faces join to others of the same mark, each such part with a number from 0.
  struct Parts {
    std::vector<int> of;  ///< each cell's; -1: it has another mark
    int count = 0;
  };
  Parts parts_of(std::span<const std::uint8_t> marks, std::uint8_t mark) const;
  /// The area of a face of a cell, out of the cell [area].
  Vec<3> out_of(std::size_t cell, std::size_t f) const;
  const Vec<3>& middle(std::size_t cell) const { return cell_middle[cell]; }
  Vec<3> middle_of_face(std::size_t f) const;
  /// The shares of a cell's nodes at a place, which sum to 1; below 0 beyond the face opposite to a node.
  std::array<double, 4> shares(std::size_t cell, const Vec<3>& place) const {
    const std::size_t count = corners();
    const Vec<3> from = minus(place, cell_middle[cell]);
    std::array<double, 4> shares{};
    for (std::size_t k = 0; k < count; ++k)
      shares[k] = 1 / static_cast<double>(count) + dot(share_slope[cell * count + k], from);
    return shares;
  }

  /// Finds faces, volumes and regions from nodes, which it puts into an order of positive volume.
  void find_faces();

 private:
  void find_shares();
};

}  // namespace tether::coupled
