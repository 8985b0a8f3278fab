// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "algebra/sparse_matrix.hpp"
#include "base/blocks.hpp"
#include "base/numbers.hpp"

namespace tether {

/// The part of GMRES that knows no matrix: an orthonormal basis of the Krylov space, and the least squares problem in
/// it. Source: Y. Saad, M. H. Schultz, SIAM J. Sci. Stat. Comput. 7 (1986) 856-869.
class KrylovBasis {
 public:
  /// Makes room for up to `most` vectors of n numbers, and one more.
  KrylovBasis(std::size_t n, int most);

  /// Starts with r / |r|; returns |r|.
  double start(std::span<const double> r);
  /// Takes up w, the matrix times the last vector, less its parts along the others; returns the least residual norm in
  /// the space so far. By modified Gram-Schmidt, again where much of w has gone.
  double add(std::span<double> w);
  int size() const { return size_; }
  bool full() const { return size_ == most_; }
  std::span<const double> last() const { return vector(size_); }
  /// The combination of the vectors that has the least residual.
  void combine(std::span<double> x) const;

 private:
  std::span<const double> vector(int k) const { return {&vectors_[static_cast<std::size_t>(k) * n_], n_}; }
  double& h(int i, int k) { return h_[at(k) * at(most_ + 1) + at(i)]; }
  double h(int i, int k) const { return h_[at(k) * at(most_ + 1) + at(i)]; }
  void take_off(std::span<double> w);
  double rotate();

  std::size_t n_;
  int most_, size_ = 0;
  std::vector<double> vectors_, h_;        // h: columns of the triangle that the rotations leave
  std::vector<double> cosine_, sine_, g_;  // of the rotations; the right side under them
};

/// Summed in the order of the entries, so that it is the same from run to run.
double dot(std::span<const double> a, std::span<const double> b);
double norm(std::span<const double> x);

/// Returns the same by blocks, whose sums are summed.
inline double dot(Team& team, std::span<const double> a, std::span<const double> b) {
  return sum_of_blocks(team, a.size(), [&](std::size_t begin, std::size_t end) {
    return dot(a.subspan(begin, end - begin), b.subspan(begin, end - begin));
  });
}
inline double norm(Team& team, std::span<const double> x) { return std::sqrt(dot(team, x, x)); }
/// y += factor x
inline void add(Team& team, double factor, std::span<const double> x, std::span<double> y) {
  each_block(team, y.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) y[i] += factor * x[i];
  });
}

/// What became of a solution.
struct KrylovResult {
  int iterations = 0;
  bool converged = false;
};

/// Solves A P^-1 (P x) = b from the first guess x by GMRES, begun anew every `restart` iterations, until
/// |b - A x| <= tolerance |b|. `multiply(x, y)`: y = A x. `precondition(r, z)`: z = P^-1 r, linear and unchanging.
template <class Multiply, class Precondition>
KrylovResult gmres(const Multiply& multiply, const Precondition& precondition, std::span<const double> b,
                   std::span<double> x, double tolerance, int restart, int most_iterations) {
  KrylovBasis basis(b.size(), restart);
  std::vector<double> r(b.size()), z(b.size());
  const double enough = tolerance * norm(b);
  KrylovResult result;
  if (enough == 0) std::fill(x.begin(), x.end(), 0.0);
  while (true) {
    multiply(x, std::span<double>(r));
    for (std::size_t i = 0; i < r.size(); ++i) r[i] = b[i] - r[i];
    double residual = basis.start(r);
    const bool finite = residual < 1e300;
    result.converged = finite && residual <= enough;
    if (result.converged || !finite || result.iterations >= most_iterations) return result;
    while (residual > enough && !basis.full() && result.iterations < most_iterations) {
      precondition(basis.last(), std::span<double>(z));
      multiply(z, std::span<double>(r));
      residual = basis.add(r);
      ++result.iterations;
    }
    basis.combine(r);
    precondition(r, std::span<double>(z));
    for (std::size_t i = 0; i < r.size(); ++i) x[i] += z[i];
  }
}

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

/// Solves A x = b, A symmetric positive definite, from the first guess x by preconditioned conjugate gradients until
/// |b - A x| <= tolerance |b|, by the residual itself and not only by its recurrence, or `most` iterations are done.
/// Where rounding alone keeps the residual from that, it has converged too, if it is below 1e-8 |b|.
/// `multiply(x, y)`: y = A x. `precondition(r, z)`: z = P^-1 r, P symmetric positive definite and about linear: the
/// direction is made conjugate by the change of the residual, which forgives a P that varies a little. Not converged
/// where A or P turns out not to be positive definite. A singular A will do where b has a solution.
/// Source: G. H. Golub, Q. Ye, SIAM J. Sci. Comput. 21 (1999) 1305-1320.
template <class Multiply, class Precondition>
KrylovResult pcg(Team& team, const Multiply& multiply, const Precondition& precondition, std::span<const double> b,
                 std::span<double> x, double tolerance, int most) {
  const std::size_t n = b.size();
  std::vector<double> r(n), z(n), p(n), q(n);
  constexpr double small = 1e-8;
  const double enough = tolerance * norm(team, b);
  double before = std::numeric_limits<double>::infinity();  // the residual at the last start from x
  KrylovResult result;
  if (enough == 0) std::fill(x.begin(), x.end(), 0.0);
  while (true) {
    multiply(std::span<const double>(x), std::span<double>(q));
    for (std::size_t i = 0; i < n; ++i) r[i] = b[i] - q[i];
    double residual = norm(team, r);
    const bool finite = residual < 1e300;
    const bool rounded = residual > 0.5 * before && residual <= small * norm(team, b);
    result.converged = finite && (residual <= enough || rounded);
    if (result.converged || !finite || result.iterations >= most) return result;
    before = residual;
    precondition(std::span<const double>(r), std::span<double>(z));
    std::copy(z.begin(), z.end(), p.begin());
    double rz = dot(team, r, z);
    while (residual > enough && result.iterations < most) {
      multiply(std::span<const double>(p), std::span<double>(q));
      const double pq = dot(team, p, q);
      if (!(rz > 0) || !(pq > 0)) return result;
      ++result.iterations;
      const double step = rz / pq;
      add(team, step, p, x), add(team, -step, q, r);
      residual = norm(team, r);
      if (!(residual > enough)) break;
      precondition(std::span<const double>(r), std::span<double>(z));
      const double change = -step * dot(team, q, z);  // (r - the r before) . z
      const double conjugate = change / rz;
      each_block(team, n, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) p[i] = z[i] + conjugate * p[i];
      });
      rz = dot(team, r, z);
    }
  }
}

}  // namespace tether
