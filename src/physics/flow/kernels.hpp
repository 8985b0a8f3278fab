// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "base/vec.hpp"
#include "grid/mesh.hpp"
#include "grid/shapes.hpp"

namespace tether::fem {

// What the Navier-Stokes equations ask at one point of quadrature, from the velocities and pressures of an element's
// nodes. Templates chosen once a run; nothing here allocates.

/// Numbers of a step that are the same everywhere.
struct FlowConstants {
  double theta = 0.5, rate = 0, rho = 0, mu = 0;
  double stabilisation = 1;  // factor of tau and tau_L
  bool newton = true;        // else the convective term's derivative is that of Picard's iteration
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
  Eigen::Vector2d tau_slope;                // (G v)/s^2 of the factor s where tau follows v1, else 0

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
    tau *= c.stabilisation, tau_L *= c.stabilisation;
    tau_slope = follows && c.stabilisation > 0 ? Eigen::Vector2d(slope / (c.stabilisation * c.stabilisation))
                                               : Eigen::Vector2d::Zero();
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
    for (int n = 0; n < NV; ++n) {
      // dR_m/dv1_n = inertia 1 + across L
      const double inertia = c.rho * (c.rate * N[n] + c.theta * carried[n]);
      const double across = c.newton ? c.rho * c.theta * N[n] : 0;
      const Eigen::Matrix2d dR = inertia * Eigen::Matrix2d::Identity() + across * L;
      for (int a = 0; a < NV; ++a) {
        Eigen::Matrix2d k = N[a] * dR + c.mu * c.theta * (G.col(n) * G.col(a).transpose());
        k.diagonal().array() += c.mu * c.theta * G.col(a).dot(G.col(n));
        if constexpr (stabilised) k += stabilised_derivative(c, a, n, dR);
        K.template block<2, 2>(2 * a, 2 * n) += weight * k;
      }
      for (int q = 0; q < NP; ++q) {
        Eigen::RowVector2d k = P[q] * G.col(n).transpose();
        if constexpr (stabilised) {
          k += tau / c.rho * (G.col(q).transpose() * dR);
          k -= tau * tau * tau / c.rho * c.theta * N[n] * G.col(q).dot(residual) * tau_slope.transpose();
        }
        K.template block<1, 2>(2 * NV + q, 2 * n) += weight * k;
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
  /// Returns the derivative of the SUPG and LSIC terms of node a by v1 of node n.
  Eigen::Matrix2d stabilised_derivative(const FlowConstants& c, int a, int n, const Eigen::Matrix2d& dR) const {
    Eigen::Matrix2d k = tau * carried[a] * dR + tau_L * G.col(a) * G.col(n).transpose();
    if (!c.newton) return k;
    k += tau * c.theta * N[n] * residual * G.col(a).transpose();
    // d tau = -tau^3/s^2 (G v) . dv, d tau_L = tau_L tau^2/s^2 (G v) . dv
    const Eigen::Vector2d by_tau = -tau * tau * tau * carried[a] * residual + tau_L * tau * tau * divergence * G.col(a);
    k += c.theta * N[n] * by_tau * tau_slope.transpose();
    return k;
  }
};

template <int n>
constexpr std::size_t index_count = static_cast<std::size_t>(n);

/// A point of quadrature on a side of a mesh, as its element sees it.
template <class V>
struct SidePoint {
  std::size_t element = 0;
  Vec<2> place;                          ///< in the reference element
  Eigen::Vector2d normal;                ///< outward, as long as the point's part of the side [length]
  Eigen::Matrix<double, V::nodes, 1> N;  ///< all of the element's functions there
  Eigen::Matrix<double, 2, V::nodes> G;  ///< and their gradients [1/length]
};

/// An element's side, 0 to 3 as add_sides() counts them.
struct ElementSide {
  std::size_t element = 0;
  int number = 0;
};

/// The elements' sides by their first and last node.
inline std::map<std::pair<int, int>, ElementSide> sides_by_ends(const Mesh& mesh) {
  const auto per_side = static_cast<std::size_t>(side_node_count_of(mesh.kind));
  std::map<std::pair<int, int>, ElementSide> found;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    Sides sides;
    add_sides(mesh.kind, mesh.element(e), sides);
    for (int k = 0; k < 4; ++k) {
      const std::size_t first = static_cast<std::size_t>(k) * per_side;
      found[{sides[first], sides[first + per_side - 1]}] = {e, k};
    }
  }
  return found;
}

/// Appends the points of quadrature of these sides of a mesh of quadrilaterals.
template <class V>
void add_side_points(const Mesh& mesh, const Sides& sides, std::vector<SidePoint<V>>& points) {
  using Line = Brick<1, V::line - 1>;
  const auto by_ends = sides_by_ends(mesh);
  const auto per_side = static_cast<std::size_t>(V::line);
  for (std::size_t first = 0; first < sides.size(); first += per_side) {
    const ElementSide of = by_ends.at({sides[first], sides[first + per_side - 1]});
    const int axis = of.number / 2, end = of.number % 2;
    const double along = (axis == 0) == (end == 1) ? 1 : -1;  // whether the side runs with the element's coordinate
    for (int k = 0; k < Line::points; ++k) {
      const double t = Line::place(k)[0];
      Vec<2> s;
      s[static_cast<std::size_t>(axis)] = end == 1 ? 1 : -1, s[static_cast<std::size_t>(1 - axis)] = along * t;
      const auto slopes = Line::gradients({t});
      Eigen::Vector2d tangent = Eigen::Vector2d::Zero();
      for (std::size_t a = 0; a < per_side; ++a)
        tangent +=
            slopes[a] * Eigen::Map<const Eigen::Vector2d>(&mesh.x[2 * static_cast<std::size_t>(sides[first + a])]);
      const auto map = jacobian_at<V>(mesh, of.element, s);
      SidePoint<V> at;
      at.element = of.element, at.place = s;
      at.normal = Line::weight(k) * Eigen::Vector2d(tangent[1], -tangent[0]);
      at.N = Eigen::Map<const Eigen::Matrix<double, V::nodes, 1>>(V::values(s).data());
      at.G = Eigen::Map<const Eigen::Matrix<double, 2, V::nodes>>(map.gradients.data());
      points.push_back(at);
    }
  }
}

}  // namespace tether::fem
