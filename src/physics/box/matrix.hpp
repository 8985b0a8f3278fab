// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "algebra/sparse_matrix.hpp"
#include "algebra/sparse_solver.hpp"
#include "algebra/two_level.hpp"
#include "physics/box/coupling_map.hpp"

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
  std::span<const std::uint8_t> held;      ///< velocities that are prescribed, as u has them
  std::span<const std::size_t> cell;       ///< of each pressure
  std::size_t cells;                       ///< of the box
  std::span<const int> region;             ///< of each pressure
  std::span<const std::uint8_t> closed;    ///< regions whose constant pressures L does not feel
  std::span<const std::uint8_t> loose;     ///< those of them that no free velocity of the solids feels either
  bool same_matrices = false;              ///< all but b, r and the values of held velocities is as it was solved last
  Definite definite = Definite::positive;  ///< what A is; else it is not symmetric either
  const CoarseUnknowns* coarse = nullptr;  ///< of the pressures, where the flow knows them
};

/// The right sides with what held velocities bring, and the value of their own rows, which are those of a multiple of
/// the identity as are those of pinned pressures, whose value is 0.
struct ReducedEquations {
  std::vector<double> b, r;
  std::vector<std::uint8_t> pinned;
  int unbalanced = -1;  ///< a loose region that more flows into than out of, or the other way; -1: none
  double flux = 0;      ///< out of it [volume/time]
};

/// u has the held velocities. Of loose regions the mean of r is taken off, which is rounding except where one is
/// reported.
ReducedEquations reduced(const CoupledEquations& equations, std::span<const double> u);
/// The first pressure of each of these regions.
std::vector<std::uint8_t> first_pressures(const CoupledEquations& equations, std::span<const std::uint8_t> regions);
/// Takes the sums of r over loose regions off, in shares of the weights: their pressures have a solution then.
void balance(const CoupledEquations& equations, std::span<const double> weight, std::span<double> r);
/// Measures for each pressure's cell the solids' surface that it sees: the sum of its row's sizes.
std::vector<double> areas_seen(const CouplingMatrix& B);
/// A with rows and columns that are set those of a multiple of the identity.
SparseMatrix held_matrix(const SparseMatrix& A, std::span<const std::uint8_t> set);

/// [A, -B^T; -B, -L], its lower triangle. Every cell has a row, those without a pressure one of the identity: so the
/// matrix keeps its size, and its order of elimination, while solids move.
SparseMatrix matrix_by_cells(const CoupledEquations& equations, std::span<const std::uint8_t> pinned);
/// L in the same way, its lower triangle.
SparseMatrix pressures_by_cells(const CoupledEquations& equations, std::span<const std::uint8_t> pinned);
/// [A, -B^T; -flux, -L], all of it.
SparseMatrix whole_matrix(const CoupledEquations& equations, std::span<const std::uint8_t> pinned);

/// K with zeros where its transpose has entries and it has none.
SparseMatrix with_symmetric_pattern(const SparseMatrix& K);

/// Returns for each unknown of K the root of its diagonal's size, or 1 where that is 0. These scales make rows and
/// columns of velocities and of pressures, whose numbers have different units, alike.
std::vector<double> scales_of(const SparseMatrix& K);
/// Divides rows and columns by their scales.
void scale(SparseMatrix& K, std::span<const double> scales);
/// The entry of a column on the diagonal; 0 where there is none.
double diagonal(const SparseMatrix& A, std::int64_t column);
/// Size of the terms of u.A u: the sum of |u_i A_ij u_j|.
double terms_size(const SparseMatrix& A, std::span<const double> u);
/// y = y + factor B x, y = y + factor B^T x.
void add_product(const CouplingMatrix& B, double factor, std::span<const double> x, std::span<double> y);
void add_transposed_product(const CouplingMatrix& B, double factor, std::span<const double> x, std::span<double> y);

}  // namespace tether::coupled
