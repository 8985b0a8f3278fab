// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "laws/elastic_response.hpp"

namespace tether {

/// Compressible neo-Hookean: Psi = mu/2 (tr C - 3 - 2 ln J) + lambda U(J) (J. C. Simo and T. J. R. Hughes,
/// Computational Inelasticity, 1998, 7.1.2, for the mixed form).
struct NeoHookean {
  double lambda = 0, mu = 0;  // [stress]
  Volumetric volumetric = Volumetric::log;
  Plane plane = Plane::strain;  // of plane bodies

  static constexpr std::string_view word = "neo-hookean", name = "neo-Hookean";
  static constexpr bool small_strains = false;
  static NeoHookean of(const ElasticConstants& given) {
    const auto [l, m] = lame(given.E, given.nu);
    return {l, m, given.volumetric, given.plane};
  }
  std::array<NamedNumber, 2> numbers() const { return {{{"lambda", lambda}, {"mu", mu}}}; }
  std::string_view note() const {
    constexpr std::string_view energies[] = {"lambda/2 ln(J)^2", "lambda/2 (J-1)^2", "lambda/4 (J^2 - 1 - 2 ln J)"};
    return energies[static_cast<int>(volumetric)];
  }
  bool plane_stress() const { return plane == Plane::stress; }
  std::optional<Lame> in_plane() const {
    if (plane == Plane::strain) return Lame{lambda, mu};
    return Lame{2 * lambda * mu / (lambda + 2 * mu), mu};
  }
  double stiffness() const { return lambda + 2 * mu; }

  template <int dim>
  Response<dim> respond(const Symmetric<dim>& C, ReferencePlace = {}) const {
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
  template <int dim>
  Across across(const Symmetric<dim>& C) const {
    const double square = 1 + determinant_less_one<dim>(C);
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
  /// Returns the response to tr C - 3, J^2 - 1 and C^-1.
  template <int dim>
  Response<dim> with_volume(double trace, double square, const Eigen::Matrix<double, dim, dim>& inverse_C) const {
    Response<dim> r;
    const Symmetric<dim> inverse = symmetric<dim>(inverse_C);
    const double ln = 0.5 * std::log1p(square), J = std::sqrt(1 + square);
    const double left = g(J) - mu;  // of the inverse
    r.energy = 0.5 * mu * (trace - 2 * ln) + U(ln, square);
    r.S = left * inverse;
    r.S.template head<dim>().array() += mu;
    r.D = J * g_slope(J) * inverse * inverse.transpose();
    constexpr int first[] = {0, 1, dim == 2 ? 0 : 2, 0, 1, 0}, second[] = {0, 1, dim == 2 ? 1 : 2, 1, 2, 2};
    for (int a = 0; a < component_count<dim>(); ++a) {
      for (int b = 0; b < component_count<dim>(); ++b) {
        const int i = first[a], j = second[a], k = first[b], l = second[b];
        r.D(a, b) -= left * (inverse_C(i, k) * inverse_C(j, l) + inverse_C(i, l) * inverse_C(j, k));
      }
    }
    return r;
  }
};

}  // namespace tether
