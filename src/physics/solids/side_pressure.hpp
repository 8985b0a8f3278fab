// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "algebra/sparse_matrix.hpp"
#include "grid/mesh.hpp"
#include "physics/solids/elements.hpp"

namespace tether::fem {

/// A pressure of 1 that pushes against sides of bodies as they lie at the time: f_A = -int N_A n da over the sides at
/// their present places, n outwards. Vectors have dim numbers a node.
///
/// The work of this force between q0 and q1 is the loss of the volume V before the sides if the force is the mean of
/// f(q0 + s (q1 - q0)) over s from 0 to 1, since f = dV/dq. The integrand is of degree dim - 1 in s, so that Simpson's
/// rule is exact. This is what StressAt::gradient takes: a constant pressure has a potential, and the step keeps it.
class SidePressure {
 public:
  /// The mesh must outlive it. All sides are on the mesh's boundary.
  SidePressure(const Mesh& mesh, const Sides& sides);

  /// Adds `pressure` times the force between q0 and q1, where `at` says [force].
  void add_forces(StressAt at, std::span<const double> q0, std::span<const double> q1, double pressure,
                  std::span<double> f) const;
  /// Adds `factor` times the derivative of that force by q1, which is not symmetric.
  void add_tangent(StressAt at, std::span<const double> q0, std::span<const double> q1, double factor,
                   const NodalPattern& pattern, SparseMatrix& K) const;

 private:
  template <class Side>
  void add_side_forces(std::size_t s, std::span<const double> q, double pressure, std::span<double> f) const;
  template <class Side>
  void add_side_tangent(std::size_t s, std::span<const double> q, double factor, std::span<double> k) const;
  std::size_t per_side() const { return static_cast<std::size_t>(side_node_count_of(mesh_.kind)); }

  const Mesh& mesh_;
  Sides sides_;
  std::vector<std::size_t> element_;  // of each side
  std::vector<int> in_element_;       // of each node of the sides: its number in that element
};

}  // namespace tether::fem
