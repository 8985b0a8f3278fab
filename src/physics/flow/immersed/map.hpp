// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "algebra/sparse_matrix.hpp"
#include "grid/point_finder.hpp"
#include "model/flow.hpp"
#include "model/solids.hpp"

namespace tether::fem {

/// The Euler-Lagrange map I of (56): from velocities of the fluid's nodes to those of solid nodes at given places, by
/// the fluid's own functions. Vectors have 2 numbers a node.
class ImmersedMap {
 public:
  /// The flow must outlive it.
  explicit ImmersedMap(const Flow& flow);

  /// Puts the solid nodes to these places. The first node that is outside of the fluid's mesh, or none.
  std::optional<std::size_t> place(std::span<const double> x);
  /// V = I v
  void velocities(std::span<const double> v, std::span<double> V) const;
  /// f += I^T F
  void add_forces(std::span<const double> F, std::span<double> f) const;

  /// The fluid's elements that solid nodes are in, ascending.
  const std::vector<int>& cells() const { return cells_; }
  /// Number in cells() of the one that a solid node is in.
  std::size_t cell_of(std::size_t node) const { return cell_[node]; }
  int nodes_per_cell() const { return count_; }
  /// Returns the nodes of a cell, of twins the one whose unknowns they share; for a solid node, their functions there.
  std::span<const int> nodes(std::size_t cell) const { return std::span(nodes_).subspan(cell * size(), size()); }
  std::span<const double> parts(std::size_t node) const { return std::span(parts_).subspan(node * size(), size()); }

 private:
  std::size_t size() const { return static_cast<std::size_t>(count_); }

  const Flow& flow_;
  PointFinder finder_;
  int count_;
  std::vector<int> element_;       // of the fluid, of each solid node
  std::vector<std::size_t> cell_;  // the same as a number in cells_
  std::vector<int> cells_, nodes_;
  std::vector<double> parts_;
};

/// The inertia that immersed solids have more than the fluid in their place, (rho_s - rho_f) dv/dt of (49), at solid
/// nodes: 2 numbers each. dv/dt = (v1 - v0)/dt + (v_t . grad) v_t where the fluid is asked, v_t and its gradient those
/// of the solid's own functions, whose slopes do not jump within an element as the fluid's do.
class ExcessInertia {
 public:
  virtual ~ExcessInertia() = default;
  /// Adds the forces at nodes that stand at x, move with v and are accelerated by `rate`, (v1 - v0)/dt.
  virtual void add_forces(std::span<const double> x, std::span<const double> v, std::span<const double> rate,
                          std::span<double> f) const = 0;
  /// Adds `by_rate` times their derivative by the rate and `by_velocity` times that by v.
  virtual void add_tangent(std::span<const double> x, std::span<const double> v, double by_rate, double by_velocity,
                           const NodalPattern& pattern, SparseMatrix& S) const = 0;
};

/// Makes the inertia of solids whose densities are those less the fluid's; null where all are the fluid's own. They
/// must outlive it.
std::unique_ptr<ExcessInertia> make_excess_inertia(const Solids& excess);

}  // namespace tether::fem
