// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include "algebra/krylov.hpp"
#include "algebra/sparse_products.hpp"
#include "base/numbers.hpp"
#include "physics/flow/immersed/solids.hpp"

namespace tether::fem {

// The forces of immersed bodies on the fluid, and their derivatives.

/// (55): I^T of stress, penalty, excess inertia and weight, and of the pressure that is not inside. What acts on
/// supported nodes their supports take.
FlowScale ImmersedSolids::add_forces(std::span<const double> p, std::span<double> f, std::span<double> g) {
  std::fill(F_.begin(), F_.end(), 0.0);
  system_.elements->add_forces(rule_, q0_, q1_, F_);
  if (penalty_) penalty_->add_forces(rule_, q0_, q1_, F_);
  if (contact_) {
    std::fill(touching_.begin(), touching_.end(), 0.0);
    contact_->add_forces(q1_, touching_);
    for (std::size_t k = 0; k < F_.size(); ++k) F_[k] += touching_[k];
  }
  const double elastic = norm(F_);
  if (open_ > 0) add_forces_of_gap();
  if (inertia_ && !moment_.rest) inertia_->add_forces(middle_, V_, rate_, F_);
  FlowScale scale;
  if (pressure_) {
    pressure_->add_forces(p, F_);
    scale.flux_rounding = 16 * std::numeric_limits<double>::epsilon() * pressure_->add_fluxes(V1_, p, g);
  }
  for (std::size_t k = 0; k < F_.size(); ++k) F_[k] -= outer_[k];
  for (std::size_t k = 0; k < F_.size(); ++k) free_[k] = system_.held[k] ? 0 : F_[k];
  carried_.gather(free_, at_carried_);
  for (std::size_t k = 0; k < at_carried_.size(); ++k) {
    if (system_.held[2 * at(carried_.nodes()[k / 2]) + k % 2]) at_carried_[k] = 0;
  }
  map_.add_forces(at_carried_, f);
  scale.force = std::max(elastic, norm(outer_)), scale.force_rounding = rounding_;
  return scale;
}

void ImmersedSolids::lead_to_carried(std::span<double> free, std::span<double> held) const {
  std::vector<double> of_free(at_carried_.size()), of_held(at_carried_.size());
  carried_.gather(free, of_free), carried_.gather(held, of_held);
  std::ranges::fill(free, 0.0), std::ranges::fill(held, 0.0);
  for (std::size_t k = 0; k < of_free.size(); ++k) {
    const std::size_t n = 2 * at(carried_.nodes()[k / 2]) + k % 2;
    (system_.held[n] ? held : free)[n] += of_free[k];
    held[n] += of_held[k];
  }
}

void ImmersedSolids::spread(std::span<const double> forces, std::span<double> f) const {
  std::vector<double> at_carried(at_carried_.size());
  carried_.gather(forces, at_carried);
  map_.add_forces(at_carried, f);
}

/// Releases the carried nodes: of those that supports hold nothing is unknown.
void ImmersedSolids::release_carried(EigenSparse& A, bool rows) const {
  const auto held = [&](Eigen::Index k) {
    return system_.held[2 * at(carried_.nodes()[static_cast<std::size_t>(k / 2)]) + static_cast<std::size_t>(k % 2)] !=
           0;
  };
  for (Eigen::Index column = 0; column < A.outerSize(); ++column) {
    for (EigenSparse::InnerIterator at(A, column); at; ++at) {
      if (held(column) || (rows && held(at.row()))) at.valueRef() = 0;
    }
  }
}

/// Finds what the last digits of places, and of velocities that add up to none over a long step, leave of the stress:
/// of each force the diagonal of the tangent times the place or way.
void ImmersedSolids::find_rounding() {
  double sum = 0;
  const double way = moment_.rest ? moment_.dt * speed_beside() : 0;
  for (std::size_t k = 0; k < q1_.size(); ++k) {
    for (auto at = S_.start[k]; at < S_.start[k + 1]; ++at) {
      const auto n = static_cast<std::size_t>(at);
      if (S_.row[n] == static_cast<std::int64_t>(k)) sum += std::pow(S_.value[n] * (std::abs(q1_[k]) + way), 2);
    }
  }
  rounding_ = std::numeric_limits<double>::epsilon() * std::sqrt(sum);
}

/// Returns the stiffness, or what has become of it, with `factor` times that of contact.
SparseMatrix& ImmersedSolids::with_contact(double factor) {
  if (!contact_) return S_;
  met_ = contact_->with_slopes(S_, q1_, factor);
  return met_;
}

void ImmersedSolids::find_stiffness() {
  S_.set_zero();
  system_.elements->add_tangent(rule_, q0_, q1_, 0, system_.pattern, S_, stresses_);
  if (penalty_) penalty_->add_tangent(rule_, q0_, q1_, 0, system_.pattern, S_);
}

/// Adds what the stress, linearised, will be once the gap is closed.
void ImmersedSolids::add_forces_of_gap() {
  find_stiffness();
  std::vector<double> forces(F_.size());
  with_contact(1).multiply(gap_, forces);
  for (std::size_t k = 0; k < F_.size(); ++k) F_[k] += open_ * forces[k];
}

/// The softest node's stiffness in its two directions, about the shear modulus G whatever the size of elements, gives
/// the time mu/G in which viscosity stops a piece as long as thick. A plate of 20 thicknesses takes 20^3 times that, a
/// flow of Re = 100 about it 100 times more: of 1e9 mu/G these are 1e-3, by which each round falls. Rounding of
/// velocities u about the body, eps u, makes ways of 2e-7 u mu/G, of the elastic ones, of the order u mu/G Re 20^3,
/// nothing that counts.
double ImmersedSolids::settling_time(double viscosity) {
  constexpr double long_enough = 1e9;
  SparseMatrix K = system_.pattern.matrix();
  system_.elements->add_tangent(rule_, solids_.mesh.x, solids_.mesh.x, 0, system_.pattern, K);
  std::vector<double> of_node(solids_.mesh.node_count(), 0.0);
  for (std::size_t k = 0; k < system_.unknowns(); ++k) {
    for (auto at = K.start[k]; at < K.start[k + 1]; ++at) {
      const auto n = static_cast<std::size_t>(at);
      if (K.row[n] == static_cast<std::int64_t>(k)) of_node[k / 2] += 0.5 * K.value[n];
    }
  }
  std::erase_if(of_node, [](double stiffness) { return !(stiffness > 0); });
  return of_node.empty() ? long_enough : long_enough * viscosity / *std::ranges::min_element(of_node);
}

double ImmersedSolids::speed_beside() const {
  double speed = 0;
  for (std::size_t cell = 0; cell < map_.cells().size(); ++cell) {
    for (const int node : map_.nodes(cell))
      speed = std::max(speed, std::hypot(difference_[2 * at(node)], difference_[2 * at(node) + 1]));
  }
  return speed;
}

/// Finds the derivative by v1 of carried nodes: that of the stress, which sees q1 = q0 + dt V, and that of the inertia.
EigenSparse ImmersedSolids::find_tangent() {
  find_stiffness();
  find_rounding();
  for (double& value : S_.value) value *= moment_.theta * moment_.dt;
  if (inertia_ && !moment_.rest) inertia_->add_tangent(middle_, V_, 1 / moment_.dt, moment_.theta, system_.pattern, S_);
  SparseMatrix& whole = with_contact(moment_.theta * moment_.dt);
  hold(whole, system_.held, 0);
  EigenSparse S = eigen_of(whole);
  if (!carried_.all()) S = congruent(S, carried_.following());
  release_carried(S, true);
  return S;
}

void ImmersedSolids::linearise() {
  const EigenSparse S = find_tangent();
  EigenSparse D;
  if (pressure_) {
    D = pressure_->divergence();
    for (Eigen::Index column = 0; column < D.outerSize(); ++column) {
      for (EigenSparse::InnerIterator at(D, column); at; ++at) {
        if (system_.held[static_cast<std::size_t>(column)]) at.valueRef() = 0;
      }
    }
    D = EigenSparse(D * carried_.following());
    release_carried(D, false);
  }
  blocks_.emplace(unknowns_, map_, pressure_ ? &*pressure_ : nullptr, S, D);
  blocks_->add_velocities(S);
  if (pressure_) blocks_->add_pressures(D);
}

}  // namespace tether::fem
