// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/friction/viscosity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "algebra/krylov.hpp"
#include "base/blocks.hpp"
#include "base/diagnostics.hpp"

namespace tether::coupled {
namespace {

constexpr double least_mass = 1e-6;  // of a whole face's: of faces at a liquid's surface that have friction alone

}  // namespace

Friction::Friction(const RubbingFluid& fluid, std::span<const double> mobility, double h)
    : fluid_(fluid),
      unknowns_(fluid.domain.grid, mobility.size()),
      slopes_(fluid.domain, unknowns_, fluid.solids),
      rates_(fluid.domain, unknowns_, slopes_, fluid.parts, fluid.beyond, h * fluid.mu),
      h_(h),
      mass_(unknowns_.count(), 0.0),
      x_(unknowns_.count(), 0.0) {
  for (std::size_t k = 0; k < mobility.size(); ++k) mass_[unknowns_.node(k)] = mobility[k] > 0 ? 1 / mobility[k] : 0;
  const double whole = fluid.domain.grid.volume();
  each_open_face([&](int axis, std::size_t f, std::size_t number) {
    mass_[number] = std::max(mass(axis, f), least_mass * fluid.density * whole);
    Combination slip;
    if (slopes_.is_attached(axis, fluid.domain.grid.place_of_face(axis, f), &slip))
      rates_.add_square(slip, nearest_surface * h * fluid.mu * whole);
  });
  rates_.find_blocks();
  std::vector<double> stiffness(unknowns_.count(), 0.0), diagonal;
  rates_.add_diagonal(stiffness);
  for (std::size_t k = 0; k < mass_.size(); ++k) {
    if (mass_[k] > 0 && stiffness[k] > 0) free_.push_back(k), diagonal.push_back(mass_[k] + stiffness[k]);
  }
  ties_.emplace(rates_, free_, diagonal, unknowns_.count());
}

template <class Function>
void Friction::each_open_face(const Function& f) const {
  const StaggeredGrid& grid = fluid_.domain.grid;
  for (int axis = 0; axis < grid.dim; ++axis) {
    for (std::size_t face = 0; face < fluid_.domain.face[at(axis)].size(); ++face) {
      if (fluid_.domain.face[at(axis)][face] == FaceKind::open)
        f(axis, face, unknowns_.face(axis, grid.place_of_face(axis, face)));
    }
  }
}

double Friction::mass(int axis, std::size_t f) const {
  return fluid_.density * fluid_.domain.volume[at(axis)][f] *
         part_of_face(fluid_.parts, fluid_.domain.grid, axis, fluid_.domain.grid.place_of_face(axis, f));
}

/// The velocities of the act before; in the first one those without their drive, which friction leaves about as they
/// are where that keeps them up. What friction does not change is as it is driven.
std::vector<double> Friction::first_guess(std::span<const double> driven_to, std::span<const double> undriven) {
  std::vector<double> guess(driven_to.begin(), driven_to.end());
  for (const std::size_t k : free_) guess[k] = begun_ ? x_[k] : undriven[k];
  begun_ = true;
  return guess;
}

/// (M + h K) e = M (x* - x) - h K x, from velocities x.
int Friction::solve(Team& team, std::span<const double> driven_to, double tolerance) {
  std::vector<double> all(x_.size(), 0.0), forces(x_.size(), 0.0), right(free_.size()), e(free_.size(), 0.0);
  rates_.find_forces(team, x_, forces);
  double terms = 0;
  for (std::size_t i = 0; i < free_.size(); ++i) {
    const std::size_t k = free_[i];
    right[i] = mass_[k] * (driven_to[k] - x_[k]) - forces[k];
    terms += mass_[k] * mass_[k] * driven_to[k] * driven_to[k];
  }
  const double residual = norm(team, right), enough = tolerance * std::max(std::sqrt(terms), residual);
  if (!(residual > enough)) return std::isfinite(residual) ? 0 : -1;
  const auto multiply = [&](std::span<const double> p, std::span<double> y) {
    for (std::size_t i = 0; i < p.size(); ++i) all[free_[i]] = p[i];
    rates_.find_forces(team, all, forces);
    for (std::size_t i = 0; i < p.size(); ++i) y[i] = mass_[free_[i]] * p[i] + forces[free_[i]];
  };
  const auto precondition = [&](std::span<const double> r, std::span<double> z) { ties_->solve(r, z); };
  constexpr int most = 20000;
  const KrylovResult result = pcg(team, multiply, precondition, right, e, enough / residual, most);
  for (std::size_t i = 0; i < e.size(); ++i) x_[free_[i]] += e[i];
  return result.converged ? result.iterations : -1;
}

Rubbed Friction::act(Team& team, std::span<const double> u, std::span<const double> driven_nodes, double tolerance,
                     const FaceValues& driven, FaceValues& v) {
  Rubbed result;
  const StaggeredGrid& grid = fluid_.domain.grid;
  const auto drive = [&](int axis, std::size_t f) { return driven[at(axis)].empty() ? 0 : h_ * driven[at(axis)][f]; };
  std::vector<double> driven_to(x_.size(), 0.0), undriven(x_.size(), 0.0);
  const auto set = [&](std::size_t number, double velocity, double by_drive) {
    driven_to[number] = velocity + by_drive, undriven[number] = velocity;
  };
  for (int axis = 0; axis < grid.dim; ++axis) {
    for (std::size_t f = 0; f < v[at(axis)].size(); ++f) {
      if (fluid_.domain.face[at(axis)][f] != FaceKind::closed)
        set(unknowns_.face(axis, grid.place_of_face(axis, f)), v[at(axis)][f], drive(axis, f));
    }
  }
  for (std::size_t k = 0; k < u.size(); ++k)
    set(unknowns_.node(k), u[k], driven_nodes.empty() ? 0 : h_ * driven_nodes[k]);
  x_ = first_guess(driven_to, undriven);
  result.iterations = solve(team, driven_to, tolerance);
  if (result.iterations < 0) return result;
  each_open_face([&](int axis, std::size_t f, std::size_t number) {
    double& now = v[at(axis)][f];
    const double after = x_[number] - drive(axis, f);
    result.taken += 0.5 * mass(axis, f) * (now * now - after * after);
    now = after;
  });
  std::vector<double> forces(x_.size(), 0.0);
  rates_.find_forces(team, x_, forces);
  for (std::size_t k = 0; k < u.size(); ++k) {
    result.impulse.push_back(-forces[unknowns_.node(k)]);
    result.nodes.push_back(x_[unknowns_.node(k)]);
  }
  result.heat = dot(team, x_, forces);
  return result;
}

}  // namespace tether::coupled
