// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "algebra/sparse_matrix.hpp"
#include "solvers/coupled/coupling_map.hpp"

namespace tether::coupled {

/// The equations of a step, (7) with one map for both couplings:
///     [  A  -B^T ] [u]   [ b ]
///     [ -B  -L   ] [p] = [ r ]
/// and what is known of them beforehand. The matrices have both triangles.
struct CoupledEquations {
  const SparseMatrix& A;  ///< of the solids
  std::span<const double> b;
  const CouplingMatrix& B;     ///< force on the solids B^T p
  const CouplingMatrix& flux;  ///< flux that they cause; B but for the paper's own
  const SparseMatrix& L;       ///< of the pressures
  std::span<const double> r;
  std::span<const std::uint8_t> held;    ///< velocities that are prescribed, as u has them
  std::span<const std::size_t> cell;     ///< of each pressure
  std::size_t cells;                     ///< of the box
  std::span<const int> region;           ///< of each pressure
  std::span<const std::uint8_t> closed;  ///< regions whose constant pressures L does not feel
  std::span<const std::uint8_t> loose;   ///< those of them that no free velocity of the solids feels either
  bool same_matrices = false;            ///< all but b, r and the values of held velocities is as it was solved last
};

}  // namespace tether::coupled
