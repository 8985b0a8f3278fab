// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <span>
#include <vector>

#include "base/team.hpp"
#include "grid/contact/pair_distance.hpp"
#include "grid/contact/surface.hpp"

namespace tether {

class BoxTree;

/// Two things of a surface that may come near to each other.
struct ContactPair {
  PairKind kind = PairKind::corner;
  /// A place and a corner, an edge's ends or a triangle's corners; or both ends of one edge, then of the other.
  std::array<int, 4> places{-1, -1, -1, -1};
  int side = -1, other = -1;  ///< of the mesh, that each belongs to; -1 of an obstacle
  double area = 0;            ///< that the distance counts for, negative where others count it twice [area]
  bool guard = false;
  std::size_t point = 0;  ///< number of its point of quadrature, where it is no guard
  double parallel = 0;  ///< of edges: square of their cross product below which they count as nearly parallel [length4]
};

/// Which bodies can meet.
struct WhoMeets {
  bool bodies = true, itself = true;
};

/// Finds pairs by a tree of boxes about what places do: between places at several times, and a slack about them.
class ContactPairs {
 public:
  /// The surface must outlive it.
  ContactPairs(const ContactSurface& surface, WhoMeets who, Team& team);

  /// Finds all pairs that can be nearer than `gap` while each place stays in the box about where it is at all of these
  /// times, grown by `slack` [length].
  void find(std::initializer_list<std::span<const double>> times, double gap, double slack);
  /// Returns whether all places at x are still in those boxes.
  bool hold(std::span<const double> x) const;
  const std::vector<ContactPair>& pairs() const { return pairs_; }

 private:
  void find_boxes(std::initializer_list<std::span<const double>> times, double slack);
  Box<3> box_of(std::span<const int> places) const;
  bool can_meet(int side, int other) const;
  bool share_a_node(int side, int other) const;
  void find_of_point(const BoxTree& facets, const BoxTree& joints, std::size_t number, double gap,
                     std::vector<ContactPair>& pairs) const;
  void find_of_guard(const BoxTree& tree, const ContactPoint& guard, double gap, std::vector<ContactPair>& pairs) const;
  void find_of_edge(const BoxTree& tree, std::size_t edge, double gap, std::vector<ContactPair>& pairs) const;
  template <class Corners>
  BoxTree tree_of(std::size_t count, const Corners& corners) const;

  const ContactSurface& surface_;
  WhoMeets who_;
  Team& team_;
  std::vector<double> low_, high_;  // of the places' boxes
  std::vector<ContactPair> pairs_;
};

/// Moves a pair's places along straight ways and returns the part of these that they can go before they are as near to
/// each other as `nearest` [length], give or take a fifth of it: 1 where nothing is in the way. They are never nearer
/// on the way (M. Li, D. M. Kaufman and C. Jiang, ACM Trans. Graph. 40 (2021) 170, additive collision detection). x and
/// ways have dim numbers a place.
double part_of_way(const ContactPair& pair, int dim, std::span<const double> x, std::span<const double> ways,
                   double nearest);

/// The squared distance of a pair with its places at x [length2].
double squared_distance(const ContactPair& pair, int dim, std::span<const double> x);

/// The vectors of a pair with its places at x.
template <PairKind kind, int dim>
[[gnu::always_inline]] inline PairVectors<dim, vector_count(kind)> vectors_of(const ContactPair& pair,
                                                                              std::span<const double> x) {
  const auto place = [&](int k) {
    return column_at<dim>(&x[static_cast<std::size_t>(pair.places[static_cast<std::size_t>(k)]) * dim]);
  };
  PairVectors<dim, vector_count(kind)> r;
  if constexpr (kind == PairKind::edges) {
    r.col(0) = place(2) - place(0), r.col(1) = place(1) - place(0), r.col(2) = place(3) - place(2);
  } else {
    r.col(0) = place(0) - place(1);
    for (int k = 1; k < vector_count(kind); ++k) r.col(k) = place(k + 1) - place(1);
  }
  return r;
}

/// Returns by which sums of its places' ways the vectors of a pair change: a row a vector, a column a place.
template <PairKind kind>
SmallMatrix<vector_count(kind), vector_count(kind) + 1> vectors_by_places() {
  if constexpr (kind == PairKind::edges) {
    return {-1., 0., 1.,  0.,  //
            -1., 1., 0.,  0.,  //
            0.,  0., -1., 1.};
  } else {
    SmallMatrix<vector_count(kind), vector_count(kind) + 1> by = decltype(by)::Zero();
    by(0, 0) = 1;
    for (int k = 0; k < vector_count(kind); ++k) by(k, 1) = -1;
    for (int k = 1; k < vector_count(kind); ++k) by(k, k + 1) = 1;
    return by;
  }
}

/// Calls f with the dimension as a constant.
template <class Function>
auto with_dim(int dim, const Function& f) {
  return dim == 2 ? f(std::integral_constant<int, 2>{}) : f(std::integral_constant<int, 3>{});
}

/// Calls f with the kind as a constant, of the plane without triangles and crossed edges.
template <int dim, class Function>
auto with_kind(PairKind kind, const Function& f) {
  if (kind == PairKind::corner) return f(std::integral_constant<PairKind, PairKind::corner>{});
  if constexpr (dim == 3) {
    if (kind == PairKind::triangle) return f(std::integral_constant<PairKind, PairKind::triangle>{});
    if (kind == PairKind::edges) return f(std::integral_constant<PairKind, PairKind::edges>{});
  }
  return f(std::integral_constant<PairKind, PairKind::edge>{});
}

}  // namespace tether
