// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>

#include "physics/solids/elements_of_shape.hpp"

namespace tether::fem {

// What elements say of their stress.

/// xx, yy, zz, xy, yz, xz at a point of quadrature, and the energy density there. Of the linear law shape and stress
/// are those of the start.
template <class Shapes>
std::array<double, 7> ElementsOf<Shapes>::cauchy_stress(std::size_t e, int k, const Square<dim>& F) const {
  const auto r = response(e, k, F);
  const bool linear = std::holds_alternative<LinearElastic>(law(e));
  double J = linear ? 1 : F.determinant();
  std::array<double, 7> values{};
  if constexpr (dim == 2) {
    const Across third = across_at(law(e), F);
    if (!linear) J *= third.stretch;
    values[2] = (linear ? 1 : third.stretch * third.stretch) * third.S / J;
  }
  const Square<dim> s = linear ? full<dim>(r.S) : Square<dim>(F * full<dim>(r.S) * F.transpose() / J);
  values[0] = s(0, 0), values[1] = s(1, 1), values[3] = s(0, 1), values[6] = r.energy;
  if constexpr (dim == 3) values[2] = s(2, 2), values[4] = s(1, 2), values[5] = s(0, 2);
  return values;
}

template <class Shapes>
std::vector<double> ElementsOf<Shapes>::nodal_stress(std::span<const double> q) const {
  constexpr std::size_t fields = 7;
  std::vector<double> sums(mesh_.node_count() * fields, 0.0), volume(mesh_.node_count(), 0.0);
  for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
    const Places at = gathered(e, q);
    for (int k = 0; k < points; ++k) {
      const Square<dim> F = deformation(at, e, k);
      const auto values = cauchy_stress(e, k, F);
      for (int a = 0; a < nodes; ++a) {
        const auto node = static_cast<std::size_t>(mesh_.element(e)[a]);
        volume[node] += weight(e, k);
        for (std::size_t f = 0; f < fields; ++f) sums[node * fields + f] += weight(e, k) * values[f];
      }
    }
  }
  for (std::size_t k = 0; k < sums.size(); ++k) sums[k] /= std::max(volume[k / fields], 1e-300);
  return sums;
}

}  // namespace tether::fem
