// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "laws/materials/elastic_response.hpp"

namespace tether {

/// A fibre along e = the circles about `centre` (in the plane, or about an axis along z): P = mu F e (x) e. [stress]
struct HoopFibre {
  double mu = 0;
  double centre_x = 0, centre_y = 0;  // [length]

  static constexpr std::string_view word = "fibre", name = "hoop fibre";
  static constexpr bool small_strains = false;
  static HoopFibre of(const ElasticConstants& given) { return {given.E, given.centre_x, given.centre_y}; }
  std::array<NamedNumber, 3> numbers() const { return {{{"mu", mu}, {"about x", centre_x}, {"y", centre_y}}}; }
  std::string_view note() const { return ""; }
  bool plane_stress() const { return false; }
  std::optional<Lame> in_plane() const { return std::nullopt; }
  double stiffness() const { return mu; }

  template <int dim>
  Response<dim> respond(const Symmetric<dim>& C, ReferencePlace at) const {
    const double dx = at.X - centre_x, dy = at.Y - centre_y, r2 = dx * dx + dy * dy;
    Response<dim> r;
    Symmetric<dim> ee = Symmetric<dim>::Zero();
    ee[0] = dy * dy / r2, ee[1] = dx * dx / r2, ee[dim == 2 ? 2 : 3] = -dx * dy / r2;
    r.energy = 0.5 * mu * (contract<dim>(C, ee) - 1);
    r.S = mu * ee;
    r.D.setZero();
    return r;
  }
  /// Nothing acts across the plane in which the fibres lie.
  template <int dim>
  Across across(const Symmetric<dim>&) const {
    return {};
  }
};

}  // namespace tether
