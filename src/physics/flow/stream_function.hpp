// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "algebra/sparse_solver.hpp"
#include "model/flow.hpp"
#include "physics/flow/elements.hpp"

namespace tether::fem {

/// The stream function psi of plane flows, u = dpsi/dy, v = -dpsi/dx, zero at the mesh's first node: the one whose
/// curl is nearest to the velocity, <grad N_A, grad psi> = <grad N_A, (-v, u)>, which holes in the mesh do not disturb,
/// among those that have one value along each line of walls that nothing flows through.
class StreamFunction {
 public:
  /// The elements must live as long.
  StreamFunction(const Flow& flow, const FlowElements& elements);
  /// Returns it at all nodes [area/time].
  std::vector<double> of(std::span<const double> v) const;

 private:
  const FlowElements& elements_;
  std::vector<int> unknown_;  // of each node; nodes of one line of walls share theirs
  SparseMatrix A_;
  mutable SparseSolver solver_;  // keeps its work space
};

}  // namespace tether::fem
