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

// One step of the friction: the unknowns, what is known of them, and their equations (M + h K) e = -h K x.
class FrictionStep {
 public:
  FrictionStep(const RubbingFluid& fluid, const RubbedNodes& nodes, double h)
      : fluid_(fluid),
        grid_(fluid.domain.grid),
        unknowns_(grid_, nodes.u.size()),
        slopes_(fluid.domain, unknowns_, fluid.solids),
        rates_(fluid.domain, unknowns_, slopes_, fluid.parts, fluid.beyond, h * fluid.mu),
        mass_(unknowns_.count(), 0.0),
        x_(unknowns_.count(), 0.0) {
    for (std::size_t k = 0; k < nodes.u.size(); ++k) {
      x_[unknowns_.node(k)] = nodes.u[k] + (nodes.driven.empty() ? 0 : h * nodes.driven[k]);
      mass_[unknowns_.node(k)] = nodes.mobility[k] > 0 ? 1 / nodes.mobility[k] : 0;
    }
  }

  /// Takes up a face with its velocity, which is known where it is prescribed, or that of the solid it lies in.
  void take(int axis, std::size_t f, double velocity) {
    const auto place = grid_.place_of_face(axis, f);
    const FaceKind kind = fluid_.domain.face[at(axis)][f];
    if (kind == FaceKind::closed) return;
    const std::size_t number = unknowns_.face(axis, place);
    x_[number] = velocity;
    if (kind == FaceKind::prescribed) return;
    const double mass = fluid_.density * fluid_.domain.volume[at(axis)][f] * liquid_of(axis, place);
    Combination slip;
    if (slopes_.is_attached(axis, place, &slip)) {
      slip.add(number, -1);
      rates_.add_square(slip, mass);
    } else {
      mass_[number] = std::max(mass, least_mass * fluid_.density * grid_.volume());
    }
  }

  /// Returns how many iterations it took; -1: they did not converge.
  int solve(Team& team, double tolerance) {
    std::vector<double> right(x_.size(), 0.0), inverse = mass_, e(x_.size(), 0.0);
    rates_.add_forces(team, x_, right);
    rates_.add_diagonal(inverse);
    double terms = 0;
    for (std::size_t k = 0; k < x_.size(); ++k) {
      right[k] = mass_[k] > 0 ? -right[k] : 0;
      inverse[k] = mass_[k] > 0 ? 1 / inverse[k] : 0;
      terms += mass_[k] * mass_[k] * x_[k] * x_[k];
    }
    const double residual = norm(team, right), enough = tolerance * std::max(std::sqrt(terms), residual);
    if (!(residual > enough)) return std::isfinite(residual) ? 0 : -1;
    const auto each = [&](const auto& set) {
      each_block(team, x_.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) set(k);
      });
    };
    const auto multiply = [&](std::span<const double> p, std::span<double> y) {
      each([&](std::size_t k) { y[k] = mass_[k] * p[k]; });
      rates_.add_forces(team, p, y);
      each([&](std::size_t k) { y[k] = mass_[k] > 0 ? y[k] : 0; });
    };
    const auto precondition = [&](std::span<const double> r, std::span<double> z) {
      each([&](std::size_t k) { z[k] = inverse[k] * r[k]; });
    };
    constexpr int most = 20000;
    const KrylovResult result = pcg(team, multiply, precondition, right, e, enough / residual, most);
    for (std::size_t k = 0; k < x_.size(); ++k) x_[k] += e[k];
    return result.converged ? result.iterations : -1;
  }

  double velocity(int axis, std::size_t f) const {
    const auto place = grid_.place_of_face(axis, f);
    Combination solid;
    if (!slopes_.is_attached(axis, place, &solid)) return x_[unknowns_.face(axis, place)];
    double velocity = 0;
    for (std::size_t k = 0; k < solid.size; ++k) velocity += solid.factor[k] * x_[solid.unknown[k]];
    return velocity;
  }
  double mass(int axis, std::size_t f) const {
    return fluid_.density * fluid_.domain.volume[at(axis)][f] * liquid_of(axis, grid_.place_of_face(axis, f));
  }
  /// What the nodes got, those whose velocity is held too: less the derivative of what friction takes.
  void take_impulse(Team& team, std::vector<double>& impulse) {
    if (impulse.empty()) return;
    std::vector<double> forces(x_.size(), 0.0);
    rates_.add_forces(team, x_, forces);
    for (std::size_t k = 0; k < impulse.size(); ++k) impulse[k] = -forces[unknowns_.node(k)];
  }

 private:
  double liquid_of(int axis, const std::array<int, 3>& place) const {
    return part_of_face(fluid_.parts, grid_, axis, place);
  }

  const RubbingFluid& fluid_;
  const StaggeredGrid& grid_;
  FrictionUnknowns unknowns_;
  Slopes slopes_;
  StrainRates rates_;
  std::vector<double> mass_, x_;  // of each unknown; no mass: it is known
};

template <class Function>
void each_open_face(const FlowDomain& domain, const Function& f) {
  for (int axis = 0; axis < domain.grid.dim; ++axis) {
    for (std::size_t face = 0; face < domain.face[at(axis)].size(); ++face) {
      if (domain.face[at(axis)][face] == FaceKind::open) f(axis, face);
    }
  }
}

}  // namespace

Rubbed add_viscosity(Team& team, const RubbingFluid& fluid, const RubbedNodes& nodes, double h, double tolerance,
                     const FaceValues& driven, FaceValues& v) {
  Rubbed result;
  result.impulse.assign(nodes.u.size(), 0.0);
  if (h * fluid.mu == 0) return result;
  FrictionStep step(fluid, nodes, h);
  for (int axis = 0; axis < fluid.domain.grid.dim; ++axis) {
    for (std::size_t f = 0; f < v[at(axis)].size(); ++f)
      step.take(axis, f, v[at(axis)][f] + (driven[at(axis)].empty() ? 0 : h * driven[at(axis)][f]));
  }
  result.iterations = step.solve(team, tolerance);
  if (result.iterations < 0)
    throw RunError("conjugate gradients do not converge for the fluid's friction: likely cause, values that ran away",
                   Failure::does_not_converge);
  each_open_face(fluid.domain, [&](int axis, std::size_t f) {
    double& now = v[at(axis)][f];
    const double after = step.velocity(axis, f) - (driven[at(axis)].empty() ? 0 : h * driven[at(axis)][f]);
    result.taken += 0.5 * step.mass(axis, f) * (now * now - after * after);
    now = after;
  });
  step.take_impulse(team, result.impulse);
  return result;
}

}  // namespace tether::coupled
