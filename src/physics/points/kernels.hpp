// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdlib>

#include "grid/kernels.hpp"
#include "loops/points.hpp"
#include "physics/points/arrays.hpp"
#include "physics/points/point_laws.hpp"

namespace tether::mpm {

// What a point gives to its nodes and takes from them. Every pass is made of these pieces, in the order of the step.

/// Transfer of velocities: a point keeps its own and takes an increment, or it takes the field about it whole.
struct Flip {
  static constexpr bool affine = false;
};
struct Apic {
  static constexpr bool affine = true;
};

/// What a run's passes are compiled for.
template <class Kernel_, class Transfer, Geometry geometry>
struct Scheme {
  using Kernel = Kernel_;
  static constexpr bool affine = Transfer::affine;
  static constexpr bool about_axis = geometry == Geometry::axisymmetric;
};

/// grad v_p = sum_i v_i (x) G_ip, its symmetric part (3.23), (4.2), and about an axis eps_theta' = v_r / r.
template <class S, class Velocity>
inline Rate rate_at(const Locator& locator, const typename S::Kernel::Place& at, const typename S::Kernel::Nodes& nodes,
                    const Velocity& velocity, double x) {
  const LinearField grad = S::Kernel::gradient(locator, at, nodes, velocity);
  Rate rate{symmetric_part({grad.by_x[0], grad.by_y[0], grad.by_x[1], grad.by_y[1]}),
            0.5 * (grad.by_y[0] - grad.by_x[1])};
  if constexpr (S::about_axis) rate.d.zz = S::Kernel::value(at, nodes, velocity)[0] / x;
  return rate;
}

inline LinearField field_about(const Points& P, std::size_t p) {
  return {pair(P.vx[p], P.vy[p]), pair(P.vxx[p], P.vyx[p]), pair(P.vxy[p], P.vyy[p])};
}

/// Calls add(node, N m, N m v) for each of the point's nodes, v with APIC's field about the point.
template <class S, class Add>
[[gnu::always_inline]] inline void each_momentum(const Points& P, std::size_t p, const Locator& locator,
                                                 const typename S::Kernel::Place& at,
                                                 const typename S::Kernel::Nodes& nodes, const Add& add) {
  const double mass = P.mass[p];
  if constexpr (S::affine) {
    S::Kernel::spread(locator, at, nodes, field_about(P, p), [&](std::size_t n, double N, Pair v) {
      const double m = N * mass;
      add(n, m, m * v);
    });
  } else {
    const auto N = S::Kernel::values(at);
    const Pair momentum = mass * pair(P.vx[p], P.vy[p]);
    for (std::size_t k = 0; k < S::Kernel::size; ++k) add(nodes[k], N[k] * mass, N[k] * momentum);
  }
}

/// Adds the point's mass and momentum to its nodes (3.15).
template <class S>
[[gnu::always_inline]] inline void map_momentum(const Points& P, std::size_t p, NodeSumsRow& sums,
                                                const Locator& locator, const typename S::Kernel::Place& at,
                                                const typename S::Kernel::Nodes& nodes) {
  each_momentum<S>(P, p, locator, at, nodes, [&](std::size_t n, double m, Pair momentum) {
    sums.m[n] += m;
    sums.momentum[n] += momentum;
  });
}

/// Does the same, and maps the mass of gas.
template <class S>
inline void map_gas_momentum(const Points& P, std::size_t p, NodeSumsRow& sums, const Locator& locator,
                             const typename S::Kernel::Place& at, const typename S::Kernel::Nodes& nodes) {
  each_momentum<S>(P, p, locator, at, nodes, [&](std::size_t n, double m, Pair momentum) {
    sums.m[n] += m;
    sums.gas[n] += m;
    sums.momentum[n] += momentum;
  });
}

/// Does the same, and maps what the ledger booked of the point, per mass.
template <class S>
inline void map_gas_momentum_and_loss(const Points& P, std::size_t p, double lost, Grid& grid, const Locator& locator,
                                      const typename S::Kernel::Place& at, const typename S::Kernel::Nodes& nodes) {
  each_momentum<S>(P, p, locator, at, nodes, [&](std::size_t n, double m, Pair momentum) {
    grid.sums.m[n] += m;
    grid.sums.gas[n] += m;
    grid.sums.momentum[n] += momentum;
    grid.loss[n] += m * lost;
  });
}

/// Calls add(node, force) with the internal force of the point on each of its nodes, -V_p sigma_p G_ip (3.16), about an
/// axis also -sigma_theta V_p N_i / r_p in r.
template <class S, class Add>
[[gnu::always_inline]] inline void each_force(const Points& P, std::size_t p, double volume, const Locator& locator,
                                              const typename S::Kernel::Place& at,
                                              const typename S::Kernel::Nodes& nodes, const Add& add) {
  const double xy = volume * P.sxy[p];
  S::Kernel::minus_divergence(locator, at, nodes, pair(volume * P.sxx[p], xy), pair(xy, volume * P.syy[p]), add);
  if constexpr (S::about_axis) {
    const auto N = S::Kernel::values(at);
    const double hoop = volume * P.szz[p] / P.x[p];
    for (std::size_t k = 0; k < S::Kernel::size; ++k) add(nodes[k], pair(-N[k] * hoop, 0));
  }
}

template <class S>
[[gnu::always_inline]] inline void map_force(const Points& P, std::size_t p, double volume, NodeSumsRow& sums,
                                             const Locator& locator, const typename S::Kernel::Place& at,
                                             const typename S::Kernel::Nodes& nodes) {
  each_force<S>(P, p, volume, locator, at, nodes, [&](std::size_t n, Pair force) { sums.force[n] += force; });
}

/// |C|^2 D of a field, of two axes, D = h^2/4 for quadratic splines; bilinear functions are not orthogonal, and what
/// the field adds to the point's energy is left out [velocity^2].
template <class S>
inline double spread_squared(const Locator& locator, const LinearField& a, const LinearField& b) {
  if constexpr (S::Kernel::size == LinearKernel::size) return 0;
  const Pair x = a.by_x * b.by_x, y = a.by_y * b.by_y;
  return 0.25 * ((x[0] + x[1]) / (locator.per_dx * locator.per_dx) + (y[0] + y[1]) / (locator.per_dy * locator.per_dy));
}

/// v . v' + C : C' D of two fields: sum_i N_i of their values' products at the nodes [velocity^2].
template <class S>
inline double product(const Locator& locator, const LinearField& a, const LinearField& b) {
  const Pair v = a.v * b.v;
  return v[0] + v[1] + spread_squared<S>(locator, a, b);
}

/// FLIP: v_p += dt sum N_i f_i / m_i (3.22). APIC: the field of sum N_i (mv)_i^L / m_i. Adds to `squares` what the
/// balance of energy wants of points: m_p |a_p|^2, or of APIC m_p |field|^2 before less after [mass velocity^2 /
/// time^2, energy].
template <class S>
inline void accelerate(Points& P, std::size_t p, double dt, const NodeMotionRow& motion, const Locator& locator,
                       const typename S::Kernel::Place& at, const typename S::Kernel::Nodes& nodes, double& squares) {
  if constexpr (S::affine) {
    const LinearField field = S::Kernel::affine(locator, at, nodes, [&](std::size_t n) { return motion.u[n]; });
    const LinearField before = field_about(P, p);
    squares += P.mass[p] * (product<S>(locator, before, before) - product<S>(locator, field, field));
    P.vx[p] = field.v[0], P.vy[p] = field.v[1];
    P.vxx[p] = field.by_x[0], P.vyx[p] = field.by_x[1], P.vxy[p] = field.by_y[0], P.vyy[p] = field.by_y[1];
  } else {
    const Pair a = S::Kernel::value(at, nodes, [&](std::size_t n) { return motion.a[n]; });
    squares += P.mass[p] * (a[0] * a[0] + a[1] * a[1]);
    const Pair v = pair(P.vx[p], P.vy[p]) + dt * a;
    P.vx[p] = v[0], P.vy[p] = v[1];
  }
}

/// x_p += dt sum N_i (mv)_i^L / m_i (3.21). Of APIC that sum is the velocity that the point has just taken. Adds m_p
/// times the way up to `lifted` [mass length].
template <class S>
inline void move(Points& P, std::size_t p, double dt, const NodeMotionRow& motion, const typename S::Kernel::Place& at,
                 const typename S::Kernel::Nodes& nodes, double& lifted) {
  Pair u = pair(P.vx[p], P.vy[p]);
  if constexpr (!S::affine) u = S::Kernel::value(at, nodes, [&](std::size_t n) { return motion.u[n]; });
  P.x[p] += dt * u[0], P.y[p] += dt * u[1];
  lifted += P.mass[p] * dt * u[1];
}

/// Takes `at` from the point's old cell to its new one: false, and trouble found, where the point left the grid or
/// jumped over a cell.
template <class Kernel>
inline bool accept_place(const Points& P, std::size_t p, const Locator& locator, const Frame& frame,
                         typename Kernel::Place& at, StepFindings& found) {
  if (!frame.contains(P.x[p], P.y[p])) return found.trouble.note(TroubleKind::left_grid, p);
  const auto before = at;
  at = Kernel::locate(locator, P.x[p], P.y[p]);
  const int di = at.i - before.i, dj = at.j - before.j;
  if ((di | dj) == 0) return true;
  ++found.crossings;
  return (std::abs(di) <= 1 && std::abs(dj) <= 1) || found.trouble.note(TroubleKind::jumped, p);
}

/// Density of the gas at its place, and the heat that the ledger gives it.
template <class Kernel>
inline void read_gas(Points& P, std::size_t p, const NodeGasRow& gas, double heat_for_all,
                     const typename Kernel::Place& at, const typename Kernel::Nodes& nodes) {
  const auto N = Kernel::values(at);
  double rho = 0, heat = heat_for_all;
  for (std::size_t k = 0; k < Kernel::size; ++k) {
    rho += N[k] * gas.rho[nodes[k]];
    heat += N[k] * gas.heat[nodes[k]];
  }
  P.rho[p] = rho;
  P.energy[p] += heat;
}

}  // namespace tether::mpm
