// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "physics/solids/elements_of_shape.hpp"

namespace tether::fem {

// What elements say of their stress.

/// xx, yy, zz, xy, yz, xz at a point of quadrature, and the energy density there, of the F that the law sees. Of the
/// linear law shape and stress are those of the start.
template <int dim>
std::array<double, stress_fields> ElementsOfShape<dim>::cauchy_stress(std::size_t e, std::size_t k,
                                                                      const Square<dim>& F) const {
  const auto r = response_at<dim>(law(e), F, place(e, k)[0], place(e, k)[1]);
  const bool linear = std::holds_alternative<LinearElastic>(law(e));
  double J = linear ? 1 : F.determinant();
  std::array<double, stress_fields> values{};
  if constexpr (dim == 2) {
    const Across third = across_at(law(e), F);
    if (!linear) J *= third.stretch;
    values[2] = (linear ? 1 : third.stretch * third.stretch) * third.S / J;
  }
  const Square<dim> s = linear ? full<dim>(r.S) : Square<dim>(F * full<dim>(r.S) * F.transpose() / J);
  values[0] = s(0, 0), values[1] = s(1, 1), values[3] = s(0, 1), values[energy_field] = r.energy;
  if constexpr (dim == 3) values[2] = s(2, 2), values[4] = s(1, 2), values[5] = s(0, 2);
  return values;
}

/// Returns the same at all points of an element.
template <int dim>
auto ElementsOfShape<dim>::stress_at_points(std::size_t e, const Vectors& places) const -> StressAtPoints {
  StressAtPoints there;
  const SeenByLaw seen = seen_by_law(places, e);
  for (std::size_t k = 0; k < points_; ++k) {
    there[k] = cauchy_stress(e, k, seen.F[k]);
    for (std::size_t i = 0; i < dim; ++i) there[k][i] += stabiliser(e) * seen.left_out[k];
  }
  return there;
}

/// Returns the same at a node of an element: its stress is carried on to it by the polynomials in which it is most
/// exact, its energy by those that have as many numbers as there are points, so that it is that of bending at a
/// surface, too.
template <int dim>
std::array<double, stress_fields> ElementsOfShape<dim>::stress_at_node(std::size_t a,
                                                                       const StressAtPoints& there) const {
  std::array<double, stress_fields> values{};
  for (std::size_t k = 0; k < points_; ++k) {
    const std::size_t part = a * points_ + k;
    for (std::size_t f = 0; f < stress_fields; ++f)
      values[f] += (f == energy_field ? shape_.parts_of_whole : shape_.parts)[part] * there[k][f];
  }
  values[energy_field] = std::max(values[energy_field], 0.0);
  return values;
}

/// Appends the stress of an element at the places where it is most exact, and these places.
template <int dim>
void ElementsOfShape<dim>::add_samples(std::size_t e, const StressAtPoints& there, StressSamples& samples) const {
  const ShapeTable::Carried& carried = samples.per_element == 1 ? shape_.at_middle : shape_.at_samples;
  const Vectors places = gathered(e, mesh_.x);
  for (std::size_t s = 0; s < at(samples.per_element); ++s) {
    const Vector x = place_of(places, &carried.values[s * nodes_]);
    samples.places.insert(samples.places.end(), x.data(), x.data() + dim);
    std::array<double, stress_parts> stress{};
    for (std::size_t k = 0; k < points_; ++k) {
      for (std::size_t f = 0; f < stress_parts; ++f) stress[f] += carried.parts[s * points_ + k] * there[k][f];
    }
    samples.stress.insert(samples.stress.end(), stress.begin(), stress.end());
  }
}

/// The mean over the elements that meet at a node, by their volumes; stresses are fitted over elements around it where
/// these are enough. Where an element has one dilatation, its pressure is most exact in its middle.
template <int dim>
std::vector<double> ElementsOfShape<dim>::nodal_stress(std::span<const double> q) const {
  const bool flat = mode_count_ == 1 && std::ranges::any_of(dilated_, &DilatationChoice::mean);
  StressSamples samples{flat ? 1 : static_cast<int>(shape_.samples), flat ? 1 : shape_.order, {}, {}, {}};
  std::vector<double> sums(mesh_.node_count() * stress_fields, 0.0), volume(mesh_.node_count(), 0.0);
  for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
    const StressAtPoints there = stress_at_points(e, gathered(e, q));
    add_samples(e, there, samples);
    double& size = samples.volumes.emplace_back(0);
    for (std::size_t k = 0; k < points_; ++k) size += weight(e, k);
    for (std::size_t a = 0; a < nodes_; ++a) {
      const auto values = stress_at_node(a, there);
      volume[node(e, a)] += size;
      for (std::size_t f = 0; f < stress_fields; ++f) sums[node(e, a) * stress_fields + f] += size * values[f];
    }
  }
  for (std::size_t k = 0; k < sums.size(); ++k) sums[k] /= std::max(volume[k / stress_fields], 1e-300);
  fit_stress(mesh_, samples, sums);
  return sums;
}

}  // namespace tether::fem
