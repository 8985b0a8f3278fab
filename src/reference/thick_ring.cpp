// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/thick_ring.hpp"

#include <fmt/format.h>
#include <array>
#include <boost/math/tools/toms748_solve.hpp>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <variant>

namespace tether {
namespace {

namespace odeint = boost::numeric::odeint;

constexpr double tolerance = 1e-12;

/// What the law answers to principal stretches a and b.
struct PrincipalStress {
  double P, Q;        // dPsi/da, dPsi/db [stress]
  double P_a, P_b;    // derivatives of P [stress]
  double energy = 0;  // Psi [energy/volume]
};

PrincipalStress principal_stress(const ElasticLaw& law, double a, double b) {
  return std::visit(
      [&](const auto& of) -> PrincipalStress {
        const bool small = small_strains(law);
        const Symmetric<2> C = small ? Symmetric<2>{2 * a - 1, 2 * b - 1, 0} : Symmetric<2>{a * a, b * b, 0};
        const Response<2> r = of.template respond<2>(C, {0, 0});
        if (small) return {r.S[0], r.S[1], r.D(0, 0), r.D(0, 1), r.energy};
        return {a * r.S[0], b * r.S[1], r.S[0] + a * a * r.D(0, 0), a * b * r.D(0, 1), r.energy};
      },
      law);
}

/// r, a, and the strain energy so far, over R.
using RingState = std::array<double, 3>;

RingState change_of(const ElasticLaw& law, const RingState& state, double R) {
  const double a = state[1], b = state[0] / R;
  const PrincipalStress s = principal_stress(law, a, b);
  const double slope = ((s.Q - s.P) / R - s.P_b * (a - b) / R) / s.P_a;
  return {a, slope, 2 * std::numbers::pi * R * s.energy};
}

/// The state at the outer radius.
RingState at_outside(const ThickRing& ring, double inner, double a) {
  RingState state{inner, a, 0};
  const auto system = [&](const RingState& at, RingState& change, double R) { change = change_of(ring.law, at, R); };
  odeint::integrate_adaptive(odeint::make_controlled<odeint::runge_kutta_dopri5<RingState>>(tolerance, tolerance),
                             system, state, ring.inner, ring.outer, 0.01 * (ring.outer - ring.inner));
  return state;
}

double outer_stress(const ThickRing& ring, const RingState& outside) {
  return principal_stress(ring.law, outside[1], outside[0] / ring.outer).P;
}

/// The stretch a at the inner radius that leaves no stress outside.
double inner_stretch(const ThickRing& ring, double inner) {
  const auto off = [&](double a) { return outer_stress(ring, at_outside(ring, inner, a)); };
  const double usual = ring.inner / inner;  // of a ring that keeps its area
  double low = usual, high = usual;
  for (int k = 0; k < 60 && !(off(low) < 0); ++k) low *= 0.97;
  for (int k = 0; k < 60 && !(off(high) > 0); ++k) high *= 1.03;
  if (!(off(low) < 0 && off(high) > 0))
    throw std::domain_error(fmt::format("no ring of this law is at rest with the inner radius {:.6g}", inner));
  std::uintmax_t iterations = 200;
  const auto [below, above] =
      boost::math::tools::toms748_solve(off, low, high, boost::math::tools::eps_tolerance<double>(48), iterations);
  return 0.5 * (below + above);
}

}  // namespace

BlownRing blown_ring(const ThickRing& ring, double inner) {
  if (!(ring.inner > 0 && ring.outer > ring.inner && inner > 0))
    throw std::domain_error(
        fmt::format("a ring of radii {:.6g} and {:.6g} with the inner radius {:.6g} is none: 0 < inner < outer",
                    ring.inner, ring.outer, inner));
  const double a = inner_stretch(ring, inner);
  const RingState outside = at_outside(ring, inner, a);
  const double P = principal_stress(ring.law, a, inner / ring.inner).P;
  const double grown = small_strains(ring.law) ? 1 : inner / ring.inner;  // of the hole that the pressure acts in
  return {.inner = inner, .outer = outside[0], .pressure = -P / grown, .energy = outside[2]};
}

}  // namespace tether
