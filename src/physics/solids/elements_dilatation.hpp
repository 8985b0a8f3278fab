// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "physics/solids/elements_of_shape.hpp"

namespace tether::fem {

// How stresses of elements change through the mean dilatation, which ties all points of an element together.

/// Sets a row to B(F)^T times a tensor: what a change of place does to a scalar with that derivative by E.
template <int dim>
void ElementsOfShape<dim>::by_places(const Square<dim>& F, const Symmetric<dim>& by_strain, const Vector* G,
                                     Row& row) const {
  const Square<dim> by_gradient = F * full<dim>(by_strain);
  for (std::size_t a = 0; a < nodes_; ++a) Eigen::Map<Vector>(&row[a * dim]).noalias() = by_gradient * G[a];
}

/// Returns each mode's part of the rows that at_point(k, row) sets for the points.
template <int dim>
template <class AtPoint>
auto ElementsOfShape<dim>::mode_rows(std::size_t e, const AtPoint& at_point) const -> ModeRows {
  const DilatationModes modes = modes_of(e);
  ModeRows sums;
  for (std::size_t m = 0; m < mode_count_; ++m) std::fill_n(sums[m].begin(), unknowns_, 0.0);
  for (std::size_t k = 0; k < points_; ++k) {
    Row row;
    at_point(k, row);
    for (std::size_t m = 0; m < mode_count_; ++m) {
      const double part = weight(e, k) * modes.at(m, k);
      for (std::size_t c = 0; c < unknowns_; ++c) sums[m][c] += part * row[c];
    }
  }
  return sums;
}

/// Adds what the points' stresses change by through the mean dilatation: of each mode the change v of all points by
/// the mode's part of J-, and P by its part of alpha.
template <int dim>
void ElementsOfShape<dim>::add_dilatation_tangent(std::size_t e, const DilatedPoints& at, std::span<double> K) const {
  const DilatationModes modes = modes_of(e);
  const auto by_strain = [&](std::size_t k, const Square<dim>& F, const Symmetric<dim>& of, Row& row) {
    by_places(F, of, gradients(e, k), row);
  };
  const ModeRows J = mode_rows(e, [&](std::size_t k, Row& row) { by_strain(k, at[k].s.F, at[k].j, row); });
  const ModeRows alpha = mode_rows(e, [&](std::size_t k, Row& row) {
    by_strain(k, at[k].s.F, at[k].a, row);
    for (std::size_t m = 0; m < mode_count_; ++m) {
      for (std::size_t c = 0; c < unknowns_; ++c) row[c] += at[k].b * modes.at(m, k) * J[m][c];
    }
  });
  const ModeRows v = mode_rows(e, [&](std::size_t k, Row& row) { by_strain(k, at[k].s.A, at[k].v, row); });
  const ModeRows P = mode_rows(e, [&](std::size_t k, Row& row) { by_strain(k, at[k].s.A, at[k].P, row); });
  for (std::size_t m = 0; m < mode_count_; ++m) {
    for (std::size_t r = 0; r < unknowns_; ++r) {
      double* row = &K[r * unknowns_];
      for (std::size_t c = 0; c < unknowns_; ++c) row[c] += v[m][r] * J[m][c] + P[m][r] * alpha[m][c];
    }
  }
}

/// Adds the same to the stresses that a change of places by `by` predicts.
template <int dim>
void ElementsOfShape<dim>::add_dilatation_to_stress(std::size_t e, const DilatedPoints& at, const Vectors& by,
                                                    std::vector<double>& stresses) const {
  const auto change = [&](std::size_t k, const Symmetric<dim>& by_strain) {
    const Square<dim> by_gradient = at[k].s.F * full<dim>(by_strain);
    double sum = 0;
    for (std::size_t a = 0; a < nodes_; ++a) sum += by[a].dot(by_gradient * gradients(e, k)[a]);
    return sum;
  };
  std::array<double, most> J, mean_J, alpha, mean_alpha;
  const auto average = [&](const std::array<double, most>& values, std::array<double, most>& mean) {
    modes_of(e).average(std::span(values).first(points_), std::span(mean).first(points_));
  };
  for (std::size_t k = 0; k < points_; ++k) J[k] = change(k, at[k].j);
  average(J, mean_J);
  for (std::size_t k = 0; k < points_; ++k) alpha[k] = change(k, at[k].a) + at[k].b * mean_J[k];
  average(alpha, mean_alpha);
  for (std::size_t k = 0; k < points_; ++k) at_point(stresses, e, k) += at[k].v * mean_J[k] + at[k].P * mean_alpha[k];
}

}  // namespace tether::fem
