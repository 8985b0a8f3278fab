// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "algebra/eigen_sparse.hpp"
#include "algebra/sparse_matrix.hpp"
#include "base/team.hpp"
#include "grid/solid_surface.hpp"
#include "physics/box/side_sums.hpp"

namespace tether::coupled {

/// Rows are pressures, columns velocities of the solids' nodes, dim a node.
using CouplingMatrix = EigenRows;

/// Which nodes a facet has entries at: its own, or the carriers of its whole side.
enum class EntriesAt { own_nodes, carriers };

/// A coupling matrix as a sum over the facets of a surface: with entries W and areas A times normals out of the solid,
/// the row r has at node a of each facet, along the axis i, W_(r a i) A_i. Where nodes move on, and each place of the
/// surface keeps the pressures that it has, A alone changes. Copies share their numbers; the surface must outlive them.
class SideMatrix {
 public:
  SideMatrix() = default;
  /// Takes W from lists, one after the other.
  SideMatrix(Team& team, const SolidSurface& surface, EntriesAt where, std::vector<SideEntries> lists, std::size_t rows,
             std::size_t columns);

  /// The matrix where facets have these areas [area].
  CouplingMatrix with(Team& team, std::span<const Vec<3>> area) const;
  /// The derivatives by the nodes' places of the product with velocities w, the areas being those of nodes at `places`.
  CouplingMatrix slopes(Team& team, std::span<const double> places, std::span<const double> w) const;
  /// Adds `factor` times those of the product of its transpose with p to K, which has entries for the nodes of a side.
  void add_force_slopes(std::span<const double> places, std::span<const double> p, double factor,
                        SparseMatrix& K) const;

 private:
  struct Entry {
    int side = 0;
    const double* W = nullptr;
  };
  struct Rows;
  std::vector<int> place_nodes(std::size_t row, Rows& of) const;
  CouplingMatrix zeros(std::span<const std::vector<int>> nodes, std::size_t columns) const;
  template <class Fill>
  CouplingMatrix filled(Team& team, const Fill& fill) const;
  std::vector<double> times_of_sides(std::span<const double> p) const;
  std::span<const int> nodes_of(int side) const;
  std::size_t place_of_own(int side, std::size_t node) const;

  const SolidSurface* surface_ = nullptr;
  EntriesAt where_ = EntriesAt::carriers;
  std::shared_ptr<const Rows> rows_;
};

}  // namespace tether::coupled
