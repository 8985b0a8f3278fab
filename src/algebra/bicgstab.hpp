// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "algebra/gmres.hpp"
#include "algebra/sparse_matrix.hpp"

namespace tether {

/// Incomplete LU factors by threshold: what is below `drop` of its row's norm is dropped, and the largest entries are
/// kept, at most `fill` times as many as an average row of the matrix has.
struct IncompleteLu {
  double drop = 1e-3;
  int fill = 10;
};

/// Solves A x = b for any A from the first guess x by Eigen's BiCGSTAB, preconditioned by its IncompleteLUT, until
/// |b - A x| <= tolerance |b|, by the residual itself and not only by its recurrence, or `most` iterations are done, or
/// 200 have left more than a tenth of the residual. Where A is singular, or the factors are no use, it does not
/// converge; x is then the best that was found.
KrylovResult bicgstab(const SparseMatrix& A, std::span<const double> b, std::span<double> x, double tolerance, int most,
                      const IncompleteLu& factors = {});

}  // namespace tether
