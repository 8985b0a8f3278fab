// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "grid/shapes.hpp"
#include "physics/flow/plane_elements.hpp"

namespace tether::fem {

// What the Navier-Stokes equations ask at one point of quadrature, from the velocities and pressures of an element's
// nodes, of which it has one number or another at run time. Nothing here allocates.

/// The pressure is bilinear in all elements.
using PressureShape = ShapesOf<ElementKind::quad4>;
inline constexpr std::size_t pressures_of_element{PressureShape::nodes};
using Pressures = std::array<double, pressures_of_element>;

inline constexpr std::size_t most_unknowns = 2 * most_plane_nodes + pressures_of_element;
/// A number of each of an element's unknowns, the first ones of these: two a node, then one a pressure.
using UnknownNumbers = std::array<double, most_unknowns>;

/// A matrix of an element's unknowns, row-major.
class UnknownMatrix {
 public:
  // Not all numbers are used, and reset() sets those that are.
  UnknownMatrix() {}  // NOLINT(modernize-use-equals-default)
  void reset(std::size_t unknowns) {
    size_ = unknowns;
    std::fill_n(numbers_.begin(), size_ * size_, 0.0);
  }
  double& operator()(std::size_t row, std::size_t column) { return numbers_[row * size_ + column]; }
  std::span<const double> numbers() const { return std::span(numbers_).first(size_ * size_); }

 private:
  std::size_t size_ = 0;
  std::array<double, most_unknowns * most_unknowns> numbers_;
};

/// Numbers of a step that are the same everywhere.
struct FlowConstants {
  double theta = 0.5, rate = 0, rho = 0, mu = 0;
  double stabilisation = 1;  // factor of tau and tau_L
  bool newton = true;        // else the convective term's derivative is that of Picard's iteration
  bool stabilised = false;   // Q1Q1
};

/// Velocities v0, v1 and v_t of an element's nodes, and its pressures.
struct NodalFlow {
  PlaneVectors v0, v1, vt;
  Pressures p;
};

struct FlowPoint {
  std::span<const double> N;  // velocity's functions
  std::span<const Vec<2>> G;  // their gradients [1/length]
  const Pressures& P;         // pressure's functions, whose gradients are G where it matters
  const PlaneMatrix& metric;  // of the map to the reference element, 4/h^2 of a square [1/length2]
  Vec<2> b;                   // body force's acceleration
  double weight;              // of the quadrature [volume]

  // What evaluate() finds.
  Vec<2> v{}, convection{}, residual{};  // v_t; (v_t . grad) v_t; R_m of (45), [velocity .. force/volume]
  PlaneMatrix L{};                       // grad v_t, L_ij = dv_i/dx_j
  PlaneNumbers carried{};                // v_t . grad N_A
  Vec<2> momentum{};                     // rho (dv/dt + convection - b)
  double p = 0, divergence = 0;          // of v1
  double tau = 0, tau_L = 0;             // stabilisation [time], [stress time]
  Vec<2> tau_slope{};                    // (G v)/s^2 of the factor s where tau follows v1, else 0

  void evaluate(const FlowConstants& c, const NodalFlow& of) {
    Vec<2> vt{}, v0{}, change{};
    PlaneMatrix slopes{};
    double growth = 0;
    for (std::size_t a = 0; a < N.size(); ++a) {
      for (std::size_t i = 0; i < 2; ++i) {
        vt[i] += N[a] * of.vt[a][i];
        v0[i] += N[a] * of.v0[a][i], change[i] += N[a] * (of.v1[a][i] - of.v0[a][i]);
        growth += of.v1[a][i] * G[a][i];
        for (std::size_t j = 0; j < 2; ++j) slopes[i][j] += of.vt[a][i] * G[a][j];
      }
    }
    v = vt, L = slopes, divergence = growth, convection = product(L, v), p = 0;
    for (std::size_t a = 0; a < N.size(); ++a) carried[a] = dot(G[a], v);
    for (std::size_t q = 0; q < pressures_of_element; ++q) p += P[q] * of.p[q];
    for (std::size_t i = 0; i < 2; ++i)  // (36), where (47) prints a minus sign
      momentum[i] = c.rho * (c.rate * change[i] + convection[i] - b[i]);
    if (!c.stabilised) return;
    residual = momentum;
    for (std::size_t q = 0; q < pressures_of_element; ++q) {
      for (std::size_t i = 0; i < 2; ++i) residual[i] += G[q][i] * of.p[q];
    }
    stabilise(c, c.rate > 0 ? v0 : v, c.rate == 0 && c.newton);
  }

  /// tau = [4/dt^2 + v . G v + 4.5 nu^2 G : G]^(-1/2), tau_L = rho/(tau tr G) of (44) with the element's metric G (T.
  /// E. Tezduyar, Adv. Appl. Mech. 28 (1992) 1-44; Y. Bazilevs et al., Comput. Methods Appl. Mech. Engrg 197 (2007)
  /// 173-201). Of unsteady flows with the velocity at the step's start, so that it has no derivative.
  void stabilise(const FlowConstants& c, const Vec<2>& with, bool follows) {
    const double nu = c.mu / c.rho;
    const Vec<2> slope = product(metric, with);
    const double squares = dot(metric[0], metric[0]) + dot(metric[1], metric[1]);
    tau = 1 / std::sqrt(4 * c.rate * c.rate + dot(with, slope) + 4.5 * nu * nu * squares);
    tau_L = c.rho / (tau * (metric[0][0] + metric[1][1]));
    tau *= c.stabilisation, tau_L *= c.stabilisation;
    const bool varies = follows && c.stabilisation > 0;
    for (std::size_t i = 0; i < 2; ++i) tau_slope[i] = varies ? slope[i] / (c.stabilisation * c.stabilisation) : 0;
  }

  /// Adds the residuals: of the momentum of each node and direction, then of incompressibility.
  void add_residual(const FlowConstants& c, UnknownNumbers& r) const {
    const double across = c.mu * (L[0][1] + L[1][0]);
    const PlaneMatrix stress{{{2 * c.mu * L[0][0] - p, across}, {across, 2 * c.mu * L[1][1] - p}}};
    for (std::size_t a = 0; a < N.size(); ++a) {
      for (std::size_t i = 0; i < 2; ++i) {
        double f = N[a] * momentum[i] + dot(stress[i], G[a]);
        if (c.stabilised) f += tau * carried[a] * residual[i] + tau_L * divergence * G[a][i];
        r[2 * a + i] += weight * f;
      }
    }
    for (std::size_t q = 0; q < pressures_of_element; ++q) {
      double g = P[q] * divergence;
      if (c.stabilised) g += tau / c.rho * dot(G[q], residual);
      r[row_of(q)] += weight * g;
    }
  }

  /// Adds their derivatives by the velocities v1 and the pressures.
  void add_tangent(const FlowConstants& c, UnknownMatrix& K) const {
    const PlaneMatrices dR = residual_slopes(c);
    for (std::size_t a = 0; a < N.size(); ++a) {
      add_momentum_tangent(c, a, dR, K);
      if (c.stabilised) add_stabilised_tangent(c, a, K);
    }
    for (std::size_t q = 0; q < pressures_of_element; ++q) {
      for (std::size_t n = 0; n < N.size(); ++n) {
        for (std::size_t j = 0; j < 2; ++j) K(row_of(q), 2 * n + j) += weight * P[q] * G[n][j];
      }
      if (c.stabilised) add_stabilised_continuity_tangent(c, q, dR, K);
    }
  }

 private:
  using PlaneMatrices = std::array<PlaneMatrix, most_plane_nodes>;  // of nodes

  std::size_t row_of(std::size_t q) const { return 2 * N.size() + q; }

  /// Returns dR_m/dv1_n = inertia 1 + across L.
  PlaneMatrices residual_slopes(const FlowConstants& c) const {
    PlaneMatrices dR;
    for (std::size_t n = 0; n < N.size(); ++n) {
      const double inertia = c.rho * (c.rate * N[n] + c.theta * carried[n]);
      const double across = c.newton ? c.rho * c.theta * N[n] : 0;
      dR[n] = {{{inertia + across * L[0][0], across * L[0][1]}, {across * L[1][0], inertia + across * L[1][1]}}};
    }
    return dR;
  }

  /// Adds node a's rows: dR_m/dv1 by N_a, with SUPG by N_a + tau v_t . grad N_a; viscosity; pressures.
  void add_momentum_tangent(const FlowConstants& c, std::size_t a, const PlaneMatrices& dR, UnknownMatrix& K) const {
    const double test = weight * (N[a] + tau * carried[a]), viscous = weight * c.mu * c.theta;
    const Vec<2> g{viscous * G[a][0], viscous * G[a][1]};
    double *x = &K(2 * a, 0), *y = &K(2 * a + 1, 0);
    for (std::size_t n = 0; n < N.size(); ++n) {
      const double around = dot(g, G[n]);
      x[2 * n] += test * dR[n][0][0] + (G[n][0] * g[0] + around);
      x[2 * n + 1] += test * dR[n][0][1] + G[n][0] * g[1];
      y[2 * n] += test * dR[n][1][0] + G[n][1] * g[0];
      y[2 * n + 1] += test * dR[n][1][1] + (G[n][1] * g[1] + around);
    }
    for (std::size_t q = 0; q < pressures_of_element; ++q) {
      x[row_of(q)] -= weight * P[q] * G[a][0];
      y[row_of(q)] -= weight * P[q] * G[a][1];
    }
  }

  /// Adds what else SUPG and LSIC have in node a's rows: tau (v_t . grad N_a) grad P_q; tau_L grad N_a div; and what
  /// v_t, tau and tau_L do to node a's part.
  void add_stabilised_tangent(const FlowConstants& c, std::size_t a, UnknownMatrix& K) const {
    const double by_v = c.newton ? c.theta : 0;
    for (std::size_t i = 0; i < 2; ++i) {
      // d tau = -tau^3/s^2 (G v) . dv, d tau_L = tau_L tau^2/s^2 (G v) . dv
      const double by_tau = tau * tau * (tau_L * divergence * G[a][i] - tau * carried[a] * residual[i]);
      const double across = weight * tau_L * G[a][i], along = weight * tau * carried[a];
      double* row = &K(2 * a + i, 0);
      Vec<2> by_velocity;
      for (std::size_t j = 0; j < 2; ++j)
        by_velocity[j] = weight * by_v * (tau * residual[i] * G[a][j] + by_tau * tau_slope[j]);
      for (std::size_t n = 0; n < N.size(); ++n) {
        for (std::size_t j = 0; j < 2; ++j) row[2 * n + j] += across * G[n][j] + N[n] * by_velocity[j];
      }
      for (std::size_t q = 0; q < pressures_of_element; ++q) row[row_of(q)] += along * G[q][i];
    }
  }

  /// Adds the derivative of PSPG's tau/rho grad P_q . R_m.
  void add_stabilised_continuity_tangent(const FlowConstants& c, std::size_t q, const PlaneMatrices& dR,
                                         UnknownMatrix& K) const {
    const Vec<2> g{weight * tau / c.rho * G[q][0], weight * tau / c.rho * G[q][1]};
    const double by_tau = tau * tau * c.theta * dot(g, residual);
    for (std::size_t n = 0; n < N.size(); ++n) {
      for (std::size_t j = 0; j < 2; ++j)
        K(row_of(q), 2 * n + j) += g[0] * dR[n][0][j] + g[1] * dR[n][1][j] - by_tau * N[n] * tau_slope[j];
    }
    for (std::size_t s = 0; s < pressures_of_element; ++s) K(row_of(q), row_of(s)) += dot(g, G[s]);
  }
};

}  // namespace tether::fem
