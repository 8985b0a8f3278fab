// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "algebra/eigen_sparse.hpp"

namespace tether {

/// E^T S E of a square S (n x n) and E (n x m): S in the unknowns that E makes its own of.
EigenSparse congruent(const EigenSparse& S, const EigenSparse& E);

/// B D B^T of B (n x m) and a diagonal D of m numbers, both triangles.
EigenSparse weighted_square(const EigenRows& B, std::span<const double> D);

}  // namespace tether
