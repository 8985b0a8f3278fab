// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "algebra/saddle_solver.hpp"
#include "algebra/sparse_solver.hpp"
#include "physics/flow/elements.hpp"
#include "physics/flow/unknowns.hpp"

namespace tether::fem {

/// What systems took.
struct LinearCounts {
  int factorisations = 0;  ///< of K, or of what GMRES works with
  int iterations = 0;      ///< of GMRES
  int failures = 0;        ///< of GMRES
};

/// What the diagonal blocks of the systems of one step are made of.
struct FlowScales {
  double viscous = 0;   ///< 2 theta mu, and the weight of <div v, div w> [stress time]
  double inertial = 0;  ///< rho/dt, 0 in steady flow [mass/volume/time]
};

/// The systems K x = b of a flow's corrections, by factors of K that many corrections may share, or by GMRES, which
/// takes each K anew.
class FlowLinear {
 public:
  /// K says which unknowns couple. Elements are asked for matrices of their pressures. The unknowns must outlive it.
  FlowLinear(const FlowUnknowns& unknowns, const FlowElements& elements, const SparseMatrix& K, Systems by);

  bool by_krylov() const { return krylov_.has_value(); }
  /// A step's first K is next. What GMRES works with is made anew, so that steps do not depend on those before them.
  void begin_step() { begun_ = false, direct_now_ = false; }
  /// Returns whether the next K is the one whose scales count.
  bool wants_scales() const { return krylov_ && !begun_; }
  /// K is that of the next solutions and must outlive them; for GMRES rows of K are scaled. False where it is
  /// singular. GMRES takes the scales of a step's first K for all of them.
  bool factorise(SparseMatrix& K, const FlowScales& scales);
  /// Solves by GMRES until |b - K x| <= tolerance |b|, momentum and incompressibility weighed as K has them. Where that
  /// does not get there, it solves directly, and does so for the rest of the step. False where K turns out singular. b
  /// and x may be the same.
  bool solve(std::span<const double> b, std::span<double> x, double tolerance);

  LinearCounts take_counts() { return std::exchange(counts_, {}); }  ///< since the last call
  double factor_nonzeros() const;                                    ///< of those that there are
  Seconds analysis() const { return direct_ ? direct_->analysis() : Seconds{}; }

 private:
  void weigh(const SparseMatrix& K);
  bool factorise_directly();

  const FlowUnknowns& of_;
  std::optional<SparseSolver> direct_;  // of GMRES the one to fall back on, once it is needed
  std::optional<SaddleSolver> krylov_;
  std::vector<std::uint8_t> is_pressure_;
  SparseMatrix* K_ = nullptr;
  double weight_ = 1;  // of the rows of incompressibility
  bool begun_ = false, direct_now_ = false;
  LinearCounts counts_;
  std::vector<double> b_;
};

}  // namespace tether::fem
