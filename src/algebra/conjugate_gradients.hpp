// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "algebra/gmres.hpp"

namespace tether {

/// Solves A x = b, A symmetric positive definite, from the first guess x by preconditioned conjugate gradients until
/// |b - A x| <= tolerance |b|, by the residual itself and not only by its recurrence, or `most` iterations are done.
/// Where rounding alone keeps the residual from that, it has converged too, if it is below 1e-8 |b|.
/// `multiply(x, y)`: y = A x. `precondition(r, z)`: z = P^-1 r, P symmetric positive definite and about linear: the
/// direction is made conjugate by the change of the residual, which forgives a P that varies a little. Not converged
/// where A or P turns out not to be positive definite. A singular A will do where b has a solution.
/// Source: G. H. Golub, Q. Ye, SIAM J. Sci. Comput. 21 (1999) 1305-1320.
template <class Multiply, class Precondition>
KrylovResult pcg(const Multiply& multiply, const Precondition& precondition, std::span<const double> b,
                 std::span<double> x, double tolerance, int most) {
  const std::size_t n = b.size();
  std::vector<double> r(n), z(n), p(n), q(n);
  constexpr double small = 1e-8;
  const double enough = tolerance * norm(b);
  double before = std::numeric_limits<double>::infinity();  // the residual at the last start from x
  KrylovResult result;
  if (enough == 0) std::fill(x.begin(), x.end(), 0.0);
  while (true) {
    multiply(std::span<const double>(x), std::span<double>(q));
    for (std::size_t i = 0; i < n; ++i) r[i] = b[i] - q[i];
    double residual = norm(r);
    const bool finite = residual < 1e300;
    const bool rounded = residual > 0.5 * before && residual <= small * norm(b);
    result.converged = finite && (residual <= enough || rounded);
    if (result.converged || !finite || result.iterations >= most) return result;
    before = residual;
    precondition(std::span<const double>(r), std::span<double>(z));
    std::copy(z.begin(), z.end(), p.begin());
    double rz = dot(r, z);
    while (residual > enough && result.iterations < most) {
      multiply(std::span<const double>(p), std::span<double>(q));
      const double pq = dot(p, q);
      if (!(rz > 0) || !(pq > 0)) return result;
      ++result.iterations;
      const double step = rz / pq;
      for (std::size_t i = 0; i < n; ++i) x[i] += step * p[i], r[i] -= step * q[i];
      residual = norm(r);
      if (!(residual > enough)) break;
      precondition(std::span<const double>(r), std::span<double>(z));
      const double change = -step * dot(q, z);  // (r - the r before) . z
      for (std::size_t i = 0; i < n; ++i) p[i] = z[i] + change / rz * p[i];
      rz = dot(r, z);
    }
  }
}

}  // namespace tether
