// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/fluid_around.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "algebra/krylov.hpp"

namespace tether::coupled {
namespace {

void go_from(std::span<const double> before, double part, std::span<const double> way, std::span<double> now) {
  for (std::size_t k = 0; k < now.size(); ++k) now[k] = before[k] + part * way[k];
}

}  // namespace

CoupledEquations FluidOfStep::equations(const CouplingMatrix& caused, const SparseMatrix& A, std::span<const double> b,
                                        std::span<const double> flux_left, std::span<const std::uint8_t> held) const {
  CoupledEquations equations{A, b, B, caused, L, flux_left, held, cell, cells, region, closed, loose};
  equations.coarse = coarse;
  return equations;
}

void FluidAround::begin(FluidOfStep step, std::span<const double> q0, std::span<const double> p) {
  step_.emplace(std::move(step));
  q0_.assign(q0.begin(), q0.end()), middle_.clear();
  std::vector<double> led(q0.begin(), q0.end());
  solids_.system.place_supports(step_->time + step_->h, led);
  turn_to(led);
  const std::vector<double> w = velocity(led), none(q0.size(), 0.0);
  const CoupledEquations at = step_->equations(step_->B, solids_.A, none, step_->r, solids_.held);
  CoupledSystem::check_balance(at, step_->time, w);
  constants_ = ConstantPressures(at);
  now_.varying.assign(p.begin(), p.end());
  now_.constant = constants_.take_means(now_.varying);
  force_of_flux_ = -1;
  keep();
}

std::vector<double> FluidAround::pressures() const {
  std::vector<double> p = now_.varying;
  constants_.add(now_.constant, p);
  return p;
}

/// Turns the map to the middle of the way to q1.
void FluidAround::turn_to(std::span<const double> q1) {
  std::vector<double> middle = middle_of(q0_, q1);
  if (middle == middle_) return;
  middle_ = std::move(middle);
  flow_.turn_map(areas_of_sides(surface_, middle_));
}

/// The pressures' forces, those of friction and of the fluid outside, and springs in the middle of the way, where the
/// work that they do on it is what they store.
void FluidAround::add_forces(std::span<const double> q1, std::span<double> f) {
  turn_to(q1);
  const CouplingMap& map = flow_.map();
  for (std::size_t k = 0; k < f.size(); ++k) f[k] += step_->drag[k] + map.outside[k] + map.film_weight[k];
  add_transposed_product(step_->B, 1, pressures(), f);
  solids_.add_spring_forces(q0_, q1, f);
}

std::vector<double> FluidAround::velocity(std::span<const double> q1) const {
  std::vector<double> w(q1.size());
  for (std::size_t k = 0; k < w.size(); ++k) w[k] = (q1[k] - q0_[k]) / step_->h;
  return w;
}

/// r + B w + L p [volume/time].
std::vector<double> FluidAround::flux_left_over(std::span<const double> w) const {
  std::vector<double> left(step_->r.size());
  step_->L.multiply(now_.varying, left);
  for (std::size_t k = 0; k < left.size(); ++k) left[k] += step_->r[k];
  add_product(step_->B, 1, w, left);
  return left;
}

/// Returns the derivative of B w by w: q1 and with it the middle's normals change, too.
CouplingMatrix FluidAround::flux_by_change(std::span<const double> w) const {
  return step_->B + 0.5 * step_->h * flow_.map().fluxes.slopes(team_, middle_, w);
}

/// Takes off what pressures and the fluid outside do more to the solids as these go on: their normals change.
void FluidAround::add_load_stiffness(SparseMatrix& A) const {
  const CouplingMap& map = flow_.map();
  map.fluxes.add_force_slopes(middle_, pressures(), -0.5, A);
  map.given.add_force_slopes(middle_, std::array{1.0, 1.0}, -0.5, A);
}

/// In terms of w the tangent is h K, and with C = d(B w)/dw the equations are those of a linear step:
///     [ h K  -B^T ] [dw]   [ right        ]
///     [ -C    -L  ] [dp] = [ r + B w + L p ]
bool FluidAround::correct(const SparseMatrix& K, std::span<const double> right, std::span<const double> q1,
                          std::span<double> change) {
  constexpr double tolerance = 1e-6;  // the next correction takes what this one leaves
  turn_to(q1);
  SparseMatrix A = K;
  solids_.add_spring_stiffness(0.5, A);
  add_load_stiffness(A);
  for (double& value : A.value) value *= step_->h;
  const std::vector<double> w = velocity(q1);
  const CouplingMatrix caused = flux_by_change(w);
  std::vector<double> left = flux_left_over(w);
  add_product(caused, 1 / step_->h, change, left);
  std::vector<double> dw(w.size(), 0.0), dp(step_->r.size(), 0.0);
  CoupledEquations equations = step_->equations(caused, A, right, left, solids_.held);
  equations.definite = Definite::general;
  if (!system_.correct(equations, tolerance, dw, dp)) return false;
  for (std::size_t k = 0; k < dw.size(); ++k) {
    if (solids_.held[k] == 0) change[k] = step_->h * dw[k];
  }
  before_ = now_;
  way_.varying = std::move(dp);
  if (force_of_flux_ < 0) find_force_of_flux(left);
  way_.constant = constants_.take_means(way_.varying);
  return true;
}

/// By the step's first correction, of which most is this answer.
void FluidAround::find_force_of_flux(std::span<const double> flux) {
  std::vector<double> forces(q0_.size(), 0.0);
  add_transposed_product(step_->B, 1, way_.varying, forces);
  const double size = norm(flux);
  force_of_flux_ = size > 0 ? norm(forces) / size : 0;
}

double FluidAround::left_over(std::span<const double> q1) {
  turn_to(q1);
  return force_of_flux_ > 0 ? force_of_flux_ * norm(flux_left_over(velocity(q1))) : 0;
}

void FluidAround::go(double part) {
  go_from(before_.varying, part, way_.varying, now_.varying);
  go_from(before_.constant, part, way_.constant, now_.constant);
}

/// The largest of the sizes of the terms in these equations, of each what rounding leaves of it: of w it is that of the
/// places.
double FluidAround::rounding(std::span<const double> q1, std::span<const double> w) const {
  constexpr double of_terms = 1e-12, of_places = 4e-16;
  std::vector<double> sizes(step_->r.size(), 0.0);
  for (std::int64_t column = 0; column < step_->L.n; ++column) {
    for (std::int64_t k = step_->L.start[static_cast<std::size_t>(column)];
         k < step_->L.start[static_cast<std::size_t>(column + 1)]; ++k) {
      const auto entry = static_cast<std::size_t>(k);
      sizes[static_cast<std::size_t>(step_->L.row[entry])] +=
          of_terms * std::abs(step_->L.value[entry] * now_.varying[static_cast<std::size_t>(column)]);
    }
  }
  double largest = 0;
  for (std::int64_t row = 0; row < step_->B.outerSize(); ++row) {
    double& size = sizes[static_cast<std::size_t>(row)];
    for (CouplingMatrix::InnerIterator entry(step_->B, row); entry; ++entry) {
      const auto k = static_cast<std::size_t>(entry.col());
      size += std::abs(entry.value()) * (of_terms * std::abs(w[k]) + of_places * std::abs(q1[k]) / step_->h);
    }
    largest = std::max(largest, size + of_terms * std::abs(step_->r[static_cast<std::size_t>(row)]));
  }
  return largest;
}

bool FluidAround::settled(std::span<const double> q1) {
  turn_to(q1);
  const std::vector<double> w = velocity(q1);
  double most = 0;
  for (const double left : flux_left_over(w)) most = std::max(most, std::abs(left));
  return most <= rounding(q1, w);
}

}  // namespace tether::coupled
