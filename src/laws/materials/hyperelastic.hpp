// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <variant>

namespace tether {

/// Symmetric tensors by their components 11, 22, 12 (plane) or 11, 22, 33, 12, 23, 13 (space), shear once.
template <int dim>
constexpr int component_count() {
  return dim == 2 ? 3 : 6;
}
template <int dim>
using Symmetric = Eigen::Matrix<double, component_count<dim>(), 1>;
/// d (a symmetric tensor) / d (a symmetric tensor): its columns are for one off-diagonal component, of which the tensor
/// has two, so that dS = D dE holds with the shears of dE counted twice.
template <int dim>
using SymmetricMap = Eigen::Matrix<double, component_count<dim>(), component_count<dim>()>;

/// Weights of the components in the product A : B.
template <int dim>
Symmetric<dim> contraction_weights() {
  if constexpr (dim == 2) {
    return {1, 1, 2};
  } else {
    return (Symmetric<dim>() << 1, 1, 1, 2, 2, 2).finished();
  }
}

/// A : B
template <int dim>
double contract(const Symmetric<dim>& a, const Symmetric<dim>& b) {
  return a.cwiseProduct(contraction_weights<dim>()).dot(b);
}

template <int dim>
Eigen::Matrix<double, dim, dim> full(const Symmetric<dim>& a) {
  if constexpr (dim == 2) {
    return (Eigen::Matrix2d() << a[0], a[2], a[2], a[1]).finished();
  } else {
    return (Eigen::Matrix3d() << a[0], a[3], a[5], a[3], a[1], a[4], a[5], a[4], a[2]).finished();
  }
}

template <int dim>
Symmetric<dim> symmetric(const Eigen::Matrix<double, dim, dim>& m) {
  if constexpr (dim == 2) {
    return {m(0, 0), m(1, 1), 0.5 * (m(0, 1) + m(1, 0))};
  } else {
    return (Symmetric<dim>() << m(0, 0), m(1, 1), m(2, 2), 0.5 * (m(0, 1) + m(1, 0)), 0.5 * (m(1, 2) + m(2, 1)),
            0.5 * (m(0, 2) + m(2, 0)))
        .finished();
  }
}

/// What a hyperelastic law answers to C = F^T F, or a linear one to 1 + 2 eps.
template <int dim>
struct Response {
  double energy = 0;    ///< Psi [energy/volume]
  Symmetric<dim> S;     ///< 2 dPsi/dC, second Piola-Kirchhoff [stress]
  SymmetricMap<dim> D;  ///< 2 dS/dC [stress]
};

/// What holds the third direction of a plane body.
enum class Plane { strain, stress };

/// The third direction of a plane body: its stretch, and the second Piola-Kirchhoff stress along it [stress].
struct Across {
  double stretch = 1, S = 0;
};

/// Lame's constants of E and nu [stress].
struct Lame {
  double lambda = 0, mu = 0;
};
inline Lame lame(double E, double nu) { return {E * nu / ((1 + nu) * (1 - 2 * nu)), E / (2 * (1 + nu))}; }

/// St Venant-Kirchhoff: Psi = lambda/2 (tr E)^2 + mu E : E, E = (C - 1)/2. With E = eps, the linear law.
struct StVenantKirchhoff {
  double lambda = 0, mu = 0;    // in plane stress lambda is 2 lambda mu/(lambda + 2 mu) [stress]
  Plane plane = Plane::strain;  // of plane bodies

  template <int dim>
  Response<dim> respond(const Symmetric<dim>& C) const {
    Response<dim> r;
    Symmetric<dim> E = 0.5 * C;
    E.template head<dim>().array() -= 0.5;
    const double trace = E.template head<dim>().sum();
    r.energy = 0.5 * lambda * trace * trace + mu * contract<dim>(E, E);
    r.S = 2 * mu * E;
    r.S.template head<dim>().array() += lambda * trace;
    r.D.setZero();
    r.D.template topLeftCorner<dim, dim>().setConstant(lambda);
    for (int k = 0; k < component_count<dim>(); ++k) r.D(k, k) += k < dim ? 2 * mu : mu;
    return r;
  }
  /// In plane stress E33 = -lambda/(lambda + 2 mu) tr E, which is the lambda here over 2 mu.
  Across across(const Symmetric<2>& C) const {
    const double trace = 0.5 * (C[0] + C[1]) - 1;
    if (plane == Plane::strain) return {1, lambda * trace};
    return {std::sqrt(std::fmax(1 - lambda / mu * trace, 0)), 0};
  }
};

/// Linear elasticity: the same with small strains about the reference shape, which turning bodies feel as strain.
struct LinearElastic {
  StVenantKirchhoff law;
};

/// A fibre along e = the circles about `centre` (in the plane, or about an axis along z): P = mu F e (x) e. [stress]
struct HoopFibre {
  double mu = 0;
  double centre_x = 0, centre_y = 0;  // [length]

  /// At the reference place X, Y.
  template <int dim>
  Response<dim> respond(const Symmetric<dim>& C, double X, double Y) const {
    const double dx = X - centre_x, dy = Y - centre_y, r2 = dx * dx + dy * dy;
    Response<dim> r;
    Symmetric<dim> ee = Symmetric<dim>::Zero();
    ee[0] = dy * dy / r2, ee[1] = dx * dx / r2, ee[dim == 2 ? 2 : 3] = -dx * dy / r2;
    r.energy = 0.5 * mu * (contract<dim>(C, ee) - 1);
    r.S = mu * ee;
    r.D.setZero();
    return r;
  }
};

/// How a neo-Hookean body resists a change of volume: lambda/2 ln(J)^2, lambda/2 (J - 1)^2, or
/// lambda/4 (J^2 - 1 - 2 ln J).
enum class Volumetric { log, square, mixed };

/// Compressible neo-Hookean: Psi = mu/2 (tr C - 3 - 2 ln J) + lambda U(J) (J. C. Simo and T. J. R. Hughes,
/// Computational Inelasticity, 1998, 7.1.2, for the mixed form).
struct NeoHookean {
  double lambda = 0, mu = 0;  // [stress]
  Volumetric volumetric = Volumetric::log;
  Plane plane = Plane::strain;  // of plane bodies

  template <int dim>
  Response<dim> respond(const Symmetric<dim>& C) const {
    const Eigen::Matrix<double, dim, dim> inverse_C = full<dim>(C).inverse();
    const double trace = (C.template head<dim>().array() - 1).sum(), det = determinant_less_one<dim>(C);
    if constexpr (dim == 3) {
      return with_volume<dim>(trace, det, inverse_C);
    } else {
      if (plane == Plane::strain) return with_volume<2>(trace, det, inverse_C);
      const double C33 = thickness_stretch_squared(1 + det), J = std::sqrt((1 + det) * C33);
      Response<2> r = with_volume<2>(trace + (C33 - 1), det * C33 + (C33 - 1), inverse_C);
      // S33 = 0 holds at each C: D_ab - D_a33 D_33b / D_3333
      const double coupling = J * g_slope(J) / C33, D33 = (2 * (mu - g(J)) + J * g_slope(J)) / (C33 * C33);
      const Symmetric<2> inverse = symmetric<2>(inverse_C);
      r.D -= (coupling * coupling / D33) * inverse * inverse.transpose();
      return r;
    }
  }
  Across across(const Symmetric<2>& C) const {
    const double square = 1 + determinant_less_one<2>(C);
    if (plane == Plane::strain) return {1, g(std::sqrt(square))};
    return {std::sqrt(thickness_stretch_squared(square)), 0};
  }

 private:
  /// det C - 1 = 2 tr E + 4 (sum of E's principal 2 x 2 minors) + 8 det E: differences of energies near C = 1 would
  /// be all rounding if it came from det C.
  template <int dim>
  static double determinant_less_one(const Symmetric<dim>& C) {
    Symmetric<dim> e = C;  // 2 E
    e.template head<dim>().array() -= 1;
    const double trace = e.template head<dim>().sum();
    if constexpr (dim == 2) {
      return trace + e[0] * e[1] - e[2] * e[2];
    } else {
      const double minors = e[0] * e[1] + e[1] * e[2] + e[2] * e[0] - e[3] * e[3] - e[4] * e[4] - e[5] * e[5];
      return trace + minors + full<3>(e).determinant();
    }
  }
  /// U, of ln J and J^2 - 1.
  double U(double ln, double square_less_one) const {
    switch (volumetric) {
      case Volumetric::log:
        return 0.5 * lambda * ln * ln;
      case Volumetric::square:
        return 0.5 * lambda * std::expm1(ln) * std::expm1(ln);
      case Volumetric::mixed:
        break;
    }
    return 0.25 * lambda * (square_less_one - 2 * ln);
  }
  /// J dU/dJ
  double g(double J) const {
    switch (volumetric) {
      case Volumetric::log:
        return lambda * std::log(J);
      case Volumetric::square:
        return lambda * J * (J - 1);
      case Volumetric::mixed:
        break;
    }
    return 0.5 * lambda * (J * J - 1);
  }
  double g_slope(double J) const {
    switch (volumetric) {
      case Volumetric::log:
        return lambda / J;
      case Volumetric::square:
        return lambda * (2 * J - 1);
      case Volumetric::mixed:
        break;
    }
    return lambda * J;
  }
  /// C33 for which S33 = mu (1 - 1/C33) + g/C33 = 0, by Newton's method in its logarithm.
  double thickness_stretch_squared(double det) const {
    double C33 = 1;
    for (int k = 0; k < 50; ++k) {
      const double J = std::sqrt(det * C33), residual = mu * (C33 - 1) + g(J);
      const double step = -residual / (mu * C33 + 0.5 * J * g_slope(J));
      C33 *= std::exp(std::fmax(-1, std::fmin(1, step)));
      if (std::abs(step) < 1e-15) break;
    }
    return C33;
  }
  /// Of tr C - 3, J^2 - 1 and C^-1.
  template <int dim>
  Response<dim> with_volume(double trace, double square, const Eigen::Matrix<double, dim, dim>& inverse_C) const {
    Response<dim> r;
    const Symmetric<dim> inverse = symmetric<dim>(inverse_C);
    const double ln = 0.5 * std::log1p(square), J = std::sqrt(1 + square);
    r.energy = 0.5 * mu * (trace - 2 * ln) + U(ln, square);
    r.S = (g(J) - mu) * inverse;
    r.S.template head<dim>().array() += mu;
    r.D = J * g_slope(J) * inverse * inverse.transpose();
    constexpr int first[] = {0, 1, dim == 2 ? 0 : 2, 0, 1, 0}, second[] = {0, 1, dim == 2 ? 1 : 2, 1, 2, 2};
    for (int a = 0; a < component_count<dim>(); ++a) {
      for (int b = 0; b < component_count<dim>(); ++b) {
        const int i = first[a], j = second[a], k = first[b], l = second[b];
        r.D(a, b) += (mu - g(J)) * (inverse_C(i, k) * inverse_C(j, l) + inverse_C(i, l) * inverse_C(j, k));
      }
    }
    return r;
  }
};

using ElasticLaw = std::variant<LinearElastic, StVenantKirchhoff, NeoHookean, HoopFibre>;

}  // namespace tether
