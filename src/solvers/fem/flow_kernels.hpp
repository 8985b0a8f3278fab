// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cmath>

// What the Navier-Stokes equations ask at one point of quadrature, from the velocities and pressures of an element's
// nodes. Templates chosen once a run; nothing here allocates.

namespace tether::fem {

/// Numbers of a step that are the same everywhere.
struct FlowConstants {
  double theta = 0.5, rate = 0, rho = 0, mu = 0;
  bool newton = true;  // else the convective term's derivative is that of Picard's iteration
};

/// Of a velocity element with NV nodes and a pressure element with NP.
template <int NV, int NP>
struct FlowPoint {
  static constexpr bool stabilised = NV == NP;  // Q1Q1
  static constexpr int size = 2 * NV + NP;
  using Velocities = Eigen::Matrix<double, 2, NV>;
  using Values = Eigen::Matrix<double, NV, 1>;
  using Pressures = Eigen::Matrix<double, NP, 1>;
  using Local = Eigen::Matrix<double, size, 1>;
  using LocalMatrix = Eigen::Matrix<double, size, size, Eigen::RowMajor>;

  const Values& N;                // velocity's functions
  const Velocities& G;            // their gradients [1/length]
  const Pressures& P;             // pressure's functions, whose gradients are G where it matters
  const Eigen::Matrix2d& metric;  // of the map to the reference element, 4/h^2 of a square [1/length2]
  const Eigen::Vector2d& b;       // body force's acceleration
  double weight;                  // of the quadrature [volume]

  // What evaluate() finds.
  Eigen::Vector2d v, convection, residual;  // v_t; (v_t . grad) v_t; R_m of (45), [velocity .. force/volume]
  Eigen::Matrix2d L;                        // grad v_t, L(i, j) = dv_i/dx_j
  Values carried;                           // v_t . grad N_A
  Eigen::Vector2d momentum;                 // rho (dv/dt + convection - b)
  double p = 0, divergence = 0;             // of v1
  double tau = 0, tau_L = 0;                // stabilisation [time], [stress time]
  Eigen::Vector2d tau_slope;                // (G v) where tau follows v1, else 0

  void evaluate(const FlowConstants& c, const Velocities& v0, const Velocities& v1, const Pressures& pressures) {
    const Velocities vt = (1 - c.theta) * v0 + c.theta * v1;
    v = vt * N, L = vt * G.transpose(), convection = L * v, carried = G.transpose() * v;
    p = P.dot(pressures), divergence = v1.cwiseProduct(G).sum();
    momentum = c.rho * (c.rate * ((v1 - v0) * N) + convection - b);  // (36), where (47) prints a minus sign
    if constexpr (stabilised) {
      residual = momentum + G * pressures;
      stabilise(c, c.rate > 0 ? Eigen::Vector2d(v0 * N) : v, c.rate == 0 && c.newton);
    }
  }

  /// tau = [4/dt^2 + v . G v + 4.5 nu^2 G : G]^(-1/2), tau_L = rho/(tau tr G) of (44) with the element's metric G (T.
  /// E. Tezduyar, Adv. Appl. Mech. 28 (1992) 1-44; Y. Bazilevs et al., Comput. Methods Appl. Mech. Engrg 197 (2007)
  /// 173-201). Of unsteady flows with the velocity at the step's start, so that it has no derivative.
  void stabilise(const FlowConstants& c, const Eigen::Vector2d& with, bool follows) {
    const double nu = c.mu / c.rho;
    const Eigen::Vector2d slope = metric * with;
    tau = 1 / std::sqrt(4 * c.rate * c.rate + with.dot(slope) + 4.5 * nu * nu * metric.squaredNorm());
    tau_L = c.rho / (tau * metric.trace());
    tau_slope = follows ? slope : Eigen::Vector2d::Zero();
  }

  /// Adds the residuals: of the momentum of each node and direction, then of incompressibility.
  void add_residual(const FlowConstants& c, Local& r) const {
    const Eigen::Matrix2d stress = c.mu * (L + L.transpose());
    for (int a = 0; a < NV; ++a) {
      Eigen::Vector2d f = N[a] * momentum + stress * G.col(a) - p * G.col(a);
      if constexpr (stabilised) f += tau * carried[a] * residual + tau_L * divergence * G.col(a);
      r.template segment<2>(2 * a) += weight * f;
    }
    for (int q = 0; q < NP; ++q) {
      double g = P[q] * divergence;
      if constexpr (stabilised) g += tau / c.rho * G.col(q).dot(residual);
      r[2 * NV + q] += weight * g;
    }
  }

  /// Adds their derivatives by the velocities v1 and the pressures.
  void add_tangent(const FlowConstants& c, LocalMatrix& K) const {
    for (int b = 0; b < NV; ++b) {
      // dR_m/dv1_b = inertia 1 + across L
      const double inertia = c.rho * (c.rate * N[b] + c.theta * carried[b]);
      const double across = c.newton ? c.rho * c.theta * N[b] : 0;
      const Eigen::Matrix2d dR = inertia * Eigen::Matrix2d::Identity() + across * L;
      for (int a = 0; a < NV; ++a) {
        Eigen::Matrix2d k = N[a] * dR + c.mu * c.theta * (G.col(b) * G.col(a).transpose());
        k.diagonal().array() += c.mu * c.theta * G.col(a).dot(G.col(b));
        if constexpr (stabilised) k += stabilised_derivative(c, a, b, dR);
        K.template block<2, 2>(2 * a, 2 * b) += weight * k;
      }
      for (int q = 0; q < NP; ++q) {
        Eigen::RowVector2d k = P[q] * G.col(b).transpose();
        if constexpr (stabilised) {
          k += tau / c.rho * (G.col(q).transpose() * dR);
          k -= tau * tau * tau / c.rho * c.theta * N[b] * G.col(q).dot(residual) * tau_slope.transpose();
        }
        K.template block<1, 2>(2 * NV + q, 2 * b) += weight * k;
      }
    }
    for (int q = 0; q < NP; ++q) {
      for (int a = 0; a < NV; ++a) {
        Eigen::Vector2d k = -P[q] * G.col(a);
        if constexpr (stabilised) k += tau * carried[a] * G.col(q);
        K.template block<2, 1>(2 * a, 2 * NV + q) += weight * k;
      }
      if constexpr (stabilised) {
        for (int s = 0; s < NP; ++s) K(2 * NV + q, 2 * NV + s) += weight * tau / c.rho * G.col(q).dot(G.col(s));
      }
    }
  }

 private:
  /// Of the SUPG and LSIC terms of node a by v1 of node b.
  Eigen::Matrix2d stabilised_derivative(const FlowConstants& c, int a, int b, const Eigen::Matrix2d& dR) const {
    Eigen::Matrix2d k = tau * carried[a] * dR + tau_L * G.col(a) * G.col(b).transpose();
    if (!c.newton) return k;
    k += tau * c.theta * N[b] * residual * G.col(a).transpose();
    // d tau = -tau^3 (G v) . dv, d tau_L = tau_L tau^2 (G v) . dv
    const Eigen::Vector2d by_tau = -tau * tau * tau * carried[a] * residual + tau_L * tau * tau * divergence * G.col(a);
    k += c.theta * N[b] * by_tau * tau_slope.transpose();
    return k;
  }
};

}  // namespace tether::fem
