// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/krylov.hpp"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>

namespace tether {
namespace {

constexpr double much = 0.7;  // of a vector left over: with less, rounding spoils that it is orthogonal

}  // namespace

double dot(std::span<const double> a, std::span<const double> b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

double norm(std::span<const double> x) { return std::sqrt(dot(x, x)); }

KrylovBasis::KrylovBasis(std::size_t n, int most) : n_(n), most_(most) {
  const auto count = static_cast<std::size_t>(most) + 1;
  vectors_.reserve(n * count);  // used as far as vectors come
  h_.resize(count * count), cosine_.resize(count), sine_.resize(count), g_.resize(count);
}

double KrylovBasis::start(std::span<const double> r) {
  const double length = norm(r);
  size_ = 0, g_[0] = length;
  vectors_.clear();
  for (const double x : r) vectors_.push_back(x / length);
  return length;
}

/// Adds what it takes off to the last column of h.
void KrylovBasis::take_off(std::span<double> w) {
  for (int k = 0; k <= size_; ++k) {
    const auto v = vector(k);
    const double part = dot(v, w);
    h(k, size_) += part;
    for (std::size_t i = 0; i < n_; ++i) w[i] -= part * v[i];
  }
}

double KrylovBasis::add(std::span<double> w) {
  const double before = norm(w);
  for (int k = 0; k <= size_; ++k) h(k, size_) = 0;
  take_off(w);
  if (norm(w) < much * before) take_off(w);
  const double left = norm(w);
  for (const double x : w) vectors_.push_back(left > 0 ? x / left : 0);
  g_[static_cast<std::size_t>(size_) + 1] = left;
  return rotate();
}

/// Makes the column of h whose last number, `left`, waits in g one of the triangle by Givens rotations.
double KrylovBasis::rotate() {
  const auto last = static_cast<std::size_t>(size_);
  for (std::size_t k = 0; k < last; ++k) {
    double &upper = h(static_cast<int>(k), size_), &lower = h(static_cast<int>(k) + 1, size_);
    const double turned = cosine_[k] * upper + sine_[k] * lower;
    lower = cosine_[k] * lower - sine_[k] * upper, upper = turned;
  }
  double& diagonal = h(size_, size_);
  const double left = g_[last + 1], length = std::hypot(diagonal, left);
  cosine_[last] = length > 0 ? diagonal / length : 1, sine_[last] = length > 0 ? left / length : 0;
  diagonal = length;
  g_[last + 1] = -sine_[last] * g_[last], g_[last] *= cosine_[last];
  ++size_;
  return std::abs(g_[last + 1]);
}

void KrylovBasis::combine(std::span<double> x) const {
  std::vector<double> y(g_.begin(), g_.begin() + size_);
  for (int k = size_ - 1; k >= 0; --k) {
    auto& yk = y[static_cast<std::size_t>(k)];
    yk = h(k, k) != 0 ? yk / h(k, k) : 0;
    for (int i = 0; i < k; ++i) y[static_cast<std::size_t>(i)] -= h(i, k) * yk;
  }
  std::fill(x.begin(), x.end(), 0.0);
  for (int k = 0; k < size_; ++k) {
    const auto v = vector(k);
    for (std::size_t i = 0; i < n_; ++i) x[i] += y[static_cast<std::size_t>(k)] * v[i];
  }
}

namespace {

using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor, std::int64_t>;
using Vector = Eigen::VectorXd;
using Solver = Eigen::BiCGSTAB<Matrix, Eigen::IncompleteLUT<double, std::int64_t>>;

/// Fewer iterations than these are not looked at; of more, the residual must have fallen to this share.
constexpr int between_looks = 200;
constexpr double enough_progress = 0.1;

}  // namespace

/// Solves by BiCGSTAB. Where the recurrence has broken down, or ended short of the residual itself, it begins anew from
/// the best x.
KrylovResult bicgstab(const SparseMatrix& A, std::span<const double> b, std::span<double> x, double tolerance, int most,
                      const IncompleteLu& factors) {
  KrylovResult result;
  const double enough = tolerance * norm(b);
  if (enough == 0) std::fill(x.begin(), x.end(), 0.0);
  const Matrix matrix = Eigen::Map<const Matrix>(A.n, A.n, static_cast<Eigen::Index>(A.row.size()), A.start.data(),
                                                 A.row.data(), A.value.data());
  const Eigen::Map<const Vector> right(b.data(), A.n);
  Eigen::Map<Vector> solution(x.data(), A.n);
  Vector best = Vector::Zero(A.n);
  double least = right.norm();
  Solver solver;
  solver.preconditioner().setDroptol(factors.drop);
  solver.preconditioner().setFillfactor(factors.fill);
  solver.setTolerance(tolerance);
  for (bool first = true;; first = false) {
    const double residual = (right - matrix * solution).norm(), before = least;
    if (residual < least) least = residual, best = solution;
    solution = best;
    result.converged = least <= enough;
    if (result.converged || result.iterations >= most || !std::isfinite(least)) return result;
    if (!first && least > enough_progress * before) return result;
    if (first) solver.compute(matrix);
    if (solver.preconditioner().info() != Eigen::Success) return result;
    solver.setMaxIterations(std::min(between_looks, most - result.iterations));
    solution = solver.solveWithGuess(right, best).eval();
    result.iterations += static_cast<int>(solver.iterations());
  }
}

}  // namespace tether
