// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "physics/solids/elements_of_shape.hpp"
#include "physics/solids/stress_recovery.hpp"

namespace tether::fem {

// What elements say of their stress.

/// xx, yy, zz, xy, yz, xz at a point of quadrature, and the energy density there, of the F that the law sees. Of the
/// linear law shape and stress are those of the start.
template <class Shapes>
std::array<double, stress_fields> ElementsOf<Shapes>::cauchy_stress(std::size_t e, int k, const Square<dim>& F) const {
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

/// Returns what points of quadrature add to a field at each node.
template <class Shapes>
auto parts_of_points(bool whole) {
  std::array<Values<Shapes::points>, std::size_t{Shapes::nodes}> parts;
  for (int a = 0; a < Shapes::nodes; ++a)
    parts[static_cast<std::size_t>(a)] = Shapes::to_place(Shapes::node_place(a), whole);
  return parts;
}

/// Returns the same at all points of an element.
template <class Shapes>
auto ElementsOf<Shapes>::stress_at_points(std::size_t e, const Places& places) const -> StressAtPoints {
  StressAtPoints there;
  const SeenByLaw seen = seen_by_law(places, e);
  for (int k = 0; k < points; ++k) {
    there[index(k)] = cauchy_stress(e, k, seen.F[index(k)]);
    for (std::size_t i = 0; i < dim; ++i) there[index(k)][i] += stabiliser(e) * seen.left_out[index(k)];
  }
  return there;
}

/// Returns the same at an element's nodes: its stress is carried on to them by the polynomials in which it is most
/// exact, its energy by those that have as many numbers as there are points, so that it is that of bending at a
/// surface, too.
template <class Shapes>
auto ElementsOf<Shapes>::stress_at_nodes(const StressAtPoints& there) const {
  static const auto linear = parts_of_points<Shapes>(false), whole = parts_of_points<Shapes>(true);
  std::array<std::array<double, stress_fields>, std::size_t{nodes}> found{};
  for (int a = 0; a < nodes; ++a) {
    auto& values = found[index(a)];
    for (int k = 0; k < points; ++k) {
      for (std::size_t f = 0; f < stress_fields; ++f)
        values[f] += (f == energy_field ? whole : linear)[index(a)][index(k)] * there[index(k)][f];
    }
    values[energy_field] = std::max(values[energy_field], 0.0);
  }
  return found;
}

/// Appends the stress of an element at the places where it is most exact, and these places.
template <class Shapes>
void ElementsOf<Shapes>::add_samples(std::size_t e, const StressAtPoints& there, StressSamples& samples) const {
  for (int s = 0; s < samples.per_element; ++s) {
    const auto place = samples.per_element == 1 ? Shapes::middle() : Shapes::sample_place(s);
    const auto parts_there = Shapes::to_place(place, false);
    const auto N = Shapes::values(place);
    const Vector x = gathered(e, mesh_.x) * Eigen::Map<const Eigen::Matrix<double, nodes, 1>>(N.data());
    samples.places.insert(samples.places.end(), x.data(), x.data() + dim);
    std::array<double, stress_parts> stress{};
    for (int k = 0; k < points; ++k) {
      for (std::size_t f = 0; f < stress_parts; ++f) stress[f] += parts_there[index(k)] * there[index(k)][f];
    }
    samples.stress.insert(samples.stress.end(), stress.begin(), stress.end());
  }
}

/// The mean over the elements that meet at a node, by their volumes; stresses are fitted over elements around it where
/// these are enough. Where an element has one dilatation, its pressure is most exact in its middle.
template <class Shapes>
std::vector<double> ElementsOf<Shapes>::nodal_stress(std::span<const double> q) const {
  const bool flat = modes == 1 && std::ranges::any_of(dilated_, &DilatationChoice::mean);
  StressSamples samples{flat ? 1 : Shapes::samples, flat ? 1 : Shapes::order, {}, {}, {}};
  std::vector<double> sums(mesh_.node_count() * stress_fields, 0.0), volume(mesh_.node_count(), 0.0);
  for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
    const StressAtPoints there = stress_at_points(e, gathered(e, q));
    const auto values = stress_at_nodes(there);
    add_samples(e, there, samples);
    double& size = samples.volumes.emplace_back(0);
    for (int k = 0; k < points; ++k) size += weight(e, k);
    for (int a = 0; a < nodes; ++a) {
      const auto node = static_cast<std::size_t>(mesh_.element(e)[a]);
      volume[node] += size;
      for (std::size_t f = 0; f < stress_fields; ++f) sums[node * stress_fields + f] += size * values[index(a)][f];
    }
  }
  for (std::size_t k = 0; k < sums.size(); ++k) sums[k] /= std::max(volume[k / stress_fields], 1e-300);
  fit_stress(mesh_, samples, sums);
  return sums;
}

}  // namespace tether::fem
