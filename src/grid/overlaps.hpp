// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "grid/solid_surface.hpp"

namespace tether {

/// Nodes of a mesh that lie inside another of its bodies, or of its own where that has come through itself.
struct Overlap {
  std::size_t nodes = 0;
  int node = -1;              ///< the first of them
  int part = -1, other = -1;  ///< the connected body that it belongs to, and the one that it lies in
  Vec<3> place{};             ///< where it is [length]
};

/// Two bodies whose sides go through each other, and where.
struct CrossedSides {
  int part = -1, other = -1;  ///< -1: none do
  Vec<3> place{};             ///< [length]
};

/// Looks for nodes inside other bodies. Bodies whose boxes are apart cost a pass over the nodes; where boxes meet, a
/// line from each node in both is followed through the sides of the other that stand in its way. Bodies that touch, to
/// a 1e-6 of their size, do not overlap. Sides of order 2 are taken as straight between their nodes.
class OverlapFinder {
 public:
  explicit OverlapFinder(const Mesh& mesh);

  int parts() const { return static_cast<int>(parts_.size()); }
  /// Finds the overlap with the nodes at q, dim numbers a node.
  Overlap find(std::span<const double> q);
  /// The first two bodies whose sides cross by more than touching, whether or not a node is inside: coarse bodies that
  /// lie across each other have none there.
  CrossedSides find_crossed(std::span<const double> q);
  /// The first of some places that lies inside a body by more than touching.
  std::optional<Vec<3>> find_held(std::span<const Vec<3>> places, std::span<const double> q);
  /// Returns how far the node of an overlap with another body is from the nearest side of that one [length].
  double depth(const Overlap& overlap, std::span<const double> q) const;

 private:
  /// A connected body: its nodes, those of its surface, and the surface as edges or triangles.
  struct Part {
    std::vector<int> nodes, rim, facets;
    Vec<3> low{}, high{};
  };
  /// Facets of one body by the columns of a lattice across x that they reach into.
  struct Columns {
    Vec<3> low{};
    std::array<double, 3> per_length{};
    std::array<int, 3> n{1, 1, 1};
    std::vector<std::size_t> start;
    std::vector<std::size_t> facet;
  };

  void find_boxes(std::span<const double> q);
  std::vector<std::size_t> facets_near(const Part& part, const Part& other, std::span<const double> q) const;
  bool cross(const Part& part, const Part& other, std::span<const double> q, double near, Vec<3>& place) const;
  void sort_facets(const Part& part, std::span<const double> q);
  int turns(const Part& part, std::span<const double> q, const Vec<3>& x) const;
  bool touches(const Part& part, std::span<const double> q, const Vec<3>& x, double near) const;
  template <class Function>
  void for_column(const Part& part, const Vec<3>& x, const Function& f) const;
  bool is_deep_in(const Part& part, std::span<const double> q, const Vec<3>& x, bool its_own) const;
  Vec<3> place(std::span<const double> q, int node) const { return place_of(q, node, dim_); }

  int dim_;
  std::vector<Part> parts_;
  std::vector<double> rounding_;  // of each part: what counts as touching [length]
  Columns columns_;               // of the part that is looked at
};

}  // namespace tether
