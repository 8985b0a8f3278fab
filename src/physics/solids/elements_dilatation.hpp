// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "physics/solids/elements_of_shape.hpp"

namespace tether::fem {

// How stresses of elements change through the mean dilatation, which ties all points of an element together.

/// Adds what the points' stresses change by through the mean dilatation: of each mode the change v of all points by
/// the mode's part of J-, and P by its part of alpha.
template <class Shapes>
void ElementsOf<Shapes>::add_dilatation_tangent(std::size_t e, const Points& all, Matrix& K) const {
  const DilatationModes of = modes_of(e);
  std::array<Row, modes> of_J;
  const auto sum = [&](std::size_t m, const auto& at_point) {
    Row row = Row::Zero();
    for (int k = 0; k < points; ++k) row += weight(e, k) * of.at(m, index(k)) * at_point(k);
    return row;
  };
  const auto& p = all.at;
  for (std::size_t m = 0; m < modes; ++m)
    of_J[m] = sum(m, [&](int k) { return by_places(p[index(k)].s.F, p[index(k)].j, gradients(e, k)); });
  for (std::size_t m = 0; m < modes; ++m) {
    const Row of_alpha = sum(m, [&](int k) -> Row {
      Row by = by_places(p[index(k)].s.F, p[index(k)].a, gradients(e, k));
      for (std::size_t n = 0; n < modes; ++n) by += p[index(k)].b * of.at(n, index(k)) * of_J[n];
      return by;
    });
    const Row v = sum(m, [&](int k) { return by_places(p[index(k)].s.A, p[index(k)].v, gradients(e, k)); });
    const Row P = sum(m, [&](int k) { return by_places(p[index(k)].s.A, p[index(k)].P, gradients(e, k)); });
    K.noalias() += v * of_J[m].transpose();
    K.noalias() += P * of_alpha.transpose();
  }
}

/// Adds the same to the stresses that a change of places by `by` predicts.
template <class Shapes>
void ElementsOf<Shapes>::add_dilatation_to_stress(std::size_t e, const Points& all, const Places& by,
                                                  std::vector<double>& stresses) const {
  std::array<double, std::size_t{points}> J{}, mean{}, alpha{}, mean_alpha{};
  const Eigen::Map<const Row> change(by.data());
  for (int k = 0; k < points; ++k)
    J[index(k)] = by_places(all.at[index(k)].s.F, all.at[index(k)].j, gradients(e, k)).dot(change);
  modes_of(e).average(J, mean);
  for (int k = 0; k < points; ++k) {
    const auto& p = all.at[index(k)];
    alpha[index(k)] = by_places(p.s.F, p.a, gradients(e, k)).dot(change) + p.b * mean[index(k)];
  }
  modes_of(e).average(alpha, mean_alpha);
  for (int k = 0; k < points; ++k) {
    const auto& p = all.at[index(k)];
    Eigen::Map<Symmetric<dim>> predicted(&stresses[(e * points + index(k)) * parts]);
    predicted += p.v * mean[index(k)] + p.P * mean_alpha[index(k)];
  }
}

}  // namespace tether::fem
