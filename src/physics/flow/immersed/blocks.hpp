// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "algebra/eigen_sparse.hpp"
#include "algebra/sparse_matrix.hpp"
#include "physics/flow/immersed/map.hpp"
#include "physics/flow/immersed/pressure.hpp"
#include "physics/flow/unknowns.hpp"

namespace tether::fem {

/// What immersed bodies add to a flow's matrix, as dense blocks of pairs of the fluid's elements: a node of such a pair
/// has three places in its block, for two velocities and a pressure.
class ImmersedBlocks {
 public:
  /// Flow, unknowns and map must outlive it. The pairs are those of the map's places: whose carried nodes S couples,
  /// and whose pressures D couples with a carried node (`pressure` may be null).
  ImmersedBlocks(const FlowUnknowns& unknowns, const ImmersedMap& map, const ImmersedPressure* pressure,
                 const EigenSparse& S, const EigenSparse& D);

  /// The nodes of each pair.
  Lists clusters() const;
  /// I^T S I of the carried nodes' two numbers each.
  void add_velocities(const EigenSparse& S);
  /// -D I in the rows of continuity, its transpose with the other sign in those of momentum, and the extension.
  void add_pressures(const EigenSparse& D);
  /// Adds the blocks to K; `first` is the number of the first of the clusters in the pattern.
  void add_to(std::size_t first, const ClusterPattern& pattern, SparseMatrix& K) const;

 private:
  using Pair = std::pair<int, int>;  // of elements, the lower one first
  static constexpr std::size_t places = 3;
  std::size_t size_of(const Pair& pair) const;
  std::size_t number_of(int a, int b) const;
  /// Returns where the nodes of an element begin in the block of a pair.
  std::size_t begin_of(int element, const Pair& pair) const;
  int element_of(std::size_t carried) const { return map_.cells()[map_.cell_of(carried)]; }

  const FlowUnknowns& unknowns_;
  const ImmersedMap& map_;
  const ImmersedPressure* pressure_;
  std::size_t per_element_;
  std::vector<Pair> pairs_;
  std::vector<std::vector<double>> blocks_;
};

}  // namespace tether::fem
