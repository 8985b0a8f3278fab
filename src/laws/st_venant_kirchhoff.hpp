// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "laws/elastic_response.hpp"

namespace tether {

/// St Venant-Kirchhoff: Psi = lambda/2 (tr E)^2 + mu E : E, E = (C - 1)/2. With E = eps, the linear law.
struct StVenantKirchhoff {
  double lambda = 0, mu = 0;    // in plane stress lambda is 2 lambda mu/(lambda + 2 mu) [stress]
  Plane plane = Plane::strain;  // of plane bodies

  static constexpr std::string_view word = "svk", name = "St Venant-Kirchhoff";
  static constexpr bool small_strains = false;
  static StVenantKirchhoff of(const ElasticConstants& given) {
    const auto [l, m] = lame(given.E, given.nu);
    return {given.plane == Plane::stress ? 2 * l * m / (l + 2 * m) : l, m, given.plane};
  }
  std::array<NamedNumber, 2> numbers() const { return {{{"lambda", lambda}, {"mu", mu}}}; }
  std::string_view note() const { return ""; }
  bool plane_stress() const { return plane == Plane::stress; }
  std::optional<Lame> in_plane() const { return Lame{lambda, mu}; }
  double stiffness() const { return lambda + 2 * mu; }

  template <int dim>
  Response<dim> respond(const Symmetric<dim>& C, ReferencePlace = {}) const {
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
  template <int dim>
  Across across(const Symmetric<dim>& C) const {
    const double trace = 0.5 * (C[0] + C[1]) - 1;
    if (plane == Plane::strain) return {1, lambda * trace};
    return {std::sqrt(std::fmax(1 - lambda / mu * trace, 0)), 0};
  }
};

/// Linear elasticity: the same with small strains about the reference shape, which turning bodies feel as strain.
struct LinearElastic {
  StVenantKirchhoff law;

  static constexpr std::string_view word = "linear", name = "linear elastic";
  static constexpr bool small_strains = true;
  static LinearElastic of(const ElasticConstants& given) { return {StVenantKirchhoff::of(given)}; }
  std::array<NamedNumber, 2> numbers() const { return law.numbers(); }
  std::string_view note() const { return ""; }
  bool plane_stress() const { return law.plane_stress(); }
  std::optional<Lame> in_plane() const { return law.in_plane(); }
  double stiffness() const { return law.stiffness(); }

  template <int dim>
  Response<dim> respond(const Symmetric<dim>& one_and_twice_strain, ReferencePlace at = {}) const {
    return law.respond<dim>(one_and_twice_strain, at);
  }
  template <int dim>
  Across across(const Symmetric<dim>& one_and_twice_strain) const {
    return law.template across<dim>(one_and_twice_strain);
  }
};

}  // namespace tether
