// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/flow/linear.hpp"

#include <algorithm>
#include <cmath>

#include "physics/flow/unknowns.hpp"

namespace tether::fem {
namespace {

SaddleUnknowns saddle_unknowns(const FlowUnknowns& unknowns) {
  SaddleUnknowns saddle{std::vector<std::uint8_t>(unknowns.count(), 0), unknowns.first, unknowns.pinned};
  for (const int p : unknowns.pressure) {
    if (p >= 0) saddle.is_pressure[static_cast<std::size_t>(p)] = 1;
  }
  return saddle;
}

}  // namespace

FlowLinear::FlowLinear(const FlowUnknowns& unknowns, const FlowElements& elements, const SparseMatrix& K, Systems by)
    : of_(unknowns), b_(unknowns.count()) {
  if (by == Systems::direct) {
    direct_.emplace(unknowns.first);
    direct_->order_by(K);
    return;
  }
  const SaddleUnknowns saddle = saddle_unknowns(unknowns);
  is_pressure_ = saddle.is_pressure;
  krylov_.emplace(saddle, elements.pressure_mass(), elements.pressure_laplacian());
}

bool FlowLinear::factorise(SparseMatrix& K, const FlowScales& scales) {
  K_ = &K;
  if (krylov_) {
    if (!begun_) {
      weigh(K);
      krylov_->forget();
      krylov_->scales(scales.viscous / weight_, scales.inertial / weight_);
    }
    for (std::size_t k = 0; k < K.row.size(); ++k) {
      if (is_pressure_[static_cast<std::size_t>(K.row[k])]) K.value[k] *= weight_;
    }
  }
  begun_ = true;
  return krylov_ && !direct_now_ ? true : factorise_directly();
}

/// GMRES takes a force and a flux for numbers of one kind. Rows of incompressibility times |A|/|D| of K = [A G; D C]
/// are as large as those of momentum, in whatever units. A power of 2 rounds nothing, and stays as it is from step to
/// step, as factors for pressures then do.
void FlowLinear::weigh(const SparseMatrix& K) {
  double A = 0, D = 0;
  for (std::size_t j = 0; j < is_pressure_.size(); ++j) {
    if (is_pressure_[j]) continue;
    for (auto k = static_cast<std::size_t>(K.start[j]); k < static_cast<std::size_t>(K.start[j + 1]); ++k)
      (is_pressure_[static_cast<std::size_t>(K.row[k])] ? D : A) += K.value[k] * K.value[k];
  }
  weight_ = A > 0 && D > 0 ? std::exp2(std::round(0.5 * std::log2(A / D))) : 1;
}

bool FlowLinear::solve(std::span<const double> b, std::span<double> x, double tolerance) {
  std::copy(b.begin(), b.end(), b_.begin());
  for (std::size_t i = 0; i < is_pressure_.size(); ++i) {
    if (is_pressure_[i]) b_[i] *= weight_;
  }
  if (krylov_ && !direct_now_) {
    std::fill(x.begin(), x.end(), 0.0);
    const bool solved = krylov_->solve(*K_, b_, x, tolerance);
    counts_.iterations += krylov_->iterations(), counts_.factorisations += krylov_->renewed();
    if (solved) return true;
    ++counts_.failures;
    direct_now_ = true;
    if (!factorise_directly()) return false;
  }
  direct_->solve(b_, x);
  return true;
}

/// After GMRES the order of elimination is that of the flow's own couplings, whichever the K is that asks first.
bool FlowLinear::factorise_directly() {
  if (!direct_) {
    direct_.emplace(of_.first);
    direct_->order_by(ClusterPattern(of_.first, clusters_of(of_.flow)).matrix());
  }
  const bool done = direct_->factorise(*K_, Definite::general);
  counts_.factorisations += done;
  return done;
}

double FlowLinear::factor_nonzeros() const {
  return krylov_ && !direct_now_ ? krylov_->factor_nonzeros() : direct_->factor_nonzeros();
}

}  // namespace tether::fem
