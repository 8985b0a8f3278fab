// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/solids/elements_of_shape.hpp"

namespace tether::fem {

// Integrals over elements that a run asks for once, or once a step.

template <int dim>
double ElementsOfShape<dim>::strain_energy(std::span<const double> q) const {
  return sum_of_blocks(
      team_, mesh_.element_count(),
      [&](std::size_t begin, std::size_t end) {
        double energy = 0;
        for (std::size_t e = begin; e < end; ++e) {
          const SeenByLaw seen = seen_by_law(gathered(e, q), e);
          for (std::size_t k = 0; k < points_; ++k) {
            const double left_out = seen.left_out[k];
            energy += weight(e, k) * (energy_at<dim>(law(e), seen.F[k], place(e, k)[0], place(e, k)[1]) +
                                      0.5 * stabiliser(e) * left_out * left_out);
          }
        }
        return energy;
      },
      elements_of_a_block);
}

/// Sets an element's mass matrix, a number a pair of nodes.
template <int dim>
void ElementsOfShape<dim>::find_mass(std::size_t e, std::span<double> m) const {
  std::ranges::fill(m, 0.0);
  for (std::size_t k = 0; k < shape_.mass_points; ++k) {
    const double* N = &shape_.mass_values[k * nodes_];
    const double w = mass_weight(e, k) * density(e);
    for (std::size_t a = 0; a < nodes_; ++a) {
      const double part = w * N[a];
      for (std::size_t b = 0; b < nodes_; ++b) m[a * nodes_ + b] += part * N[b];
    }
  }
}

template <int dim>
SparseMatrix ElementsOfShape<dim>::mass() const {
  const NodalPattern pattern(1, mesh_.node_count(), mesh_.nodes, static_cast<int>(nodes_));
  SparseMatrix M = pattern.matrix();
  std::vector<double> own(nodes_ * nodes_);
  for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
    find_mass(e, own);
    pattern.add(e, own, M);
  }
  return M;
}

/// Adds `inertia` times the mass matrix, for each direction.
template <int dim>
void ElementsOfShape<dim>::add_inertia(std::size_t e, double inertia, std::span<double> K) const {
  std::array<double, most * most> all;
  const std::span<double> m = std::span(all).first(nodes_ * nodes_);
  find_mass(e, m);
  for (std::size_t a = 0; a < nodes_; ++a) {
    for (std::size_t b = 0; b < nodes_; ++b) {
      for (std::size_t i = 0; i < dim; ++i) K[(a * dim + i) * unknowns_ + b * dim + i] += inertia * m[a * nodes_ + b];
    }
  }
}

/// The diagonal of an element's mass matrix, scaled to its volume (E. Hinton, T. Rock and O. C. Zienkiewicz, Earthquake
/// Engng Struct. Dyn. 4 (1976) 245-249); for linear functions these are the row sums.
template <int dim>
std::vector<double> ElementsOfShape<dim>::lumped_volumes(int region) const {
  std::vector<double> lumped(mesh_.node_count(), 0.0);
  for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
    if (mesh_.region[e] != region) continue;
    std::array<double, most> diagonal{};
    double volume = 0, trace = 0;
    for (std::size_t k = 0; k < shape_.mass_points; ++k) {
      const double* N = &shape_.mass_values[k * nodes_];
      const double w = mass_weight(e, k);
      volume += w;
      for (std::size_t a = 0; a < nodes_; ++a) diagonal[a] += w * N[a] * N[a];
    }
    for (std::size_t a = 0; a < nodes_; ++a) trace += diagonal[a];
    for (std::size_t a = 0; a < nodes_; ++a) lumped[node(e, a)] += diagonal[a] * volume / trace;
  }
  return lumped;
}

template <int dim>
std::vector<double> ElementsOfShape<dim>::volumes(int region) const {
  std::vector<double> volumes(mesh_.node_count(), 0.0);
  for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
    if (mesh_.region[e] != region) continue;
    for (std::size_t k = 0; k < points_; ++k) {
      for (std::size_t a = 0; a < nodes_; ++a) volumes[node(e, a)] += weight(e, k) * shape_.values[k * nodes_ + a];
    }
  }
  return volumes;
}

template <int dim>
double ElementsOfShape<dim>::least_mean_dilatation(const Vectors& at, std::size_t e) const {
  std::array<double, most> J, mean;
  for (std::size_t k = 0; k < points_; ++k) J[k] = deformation(at, e, k).determinant();
  modes_of(e).average(std::span(J).first(points_), std::span(mean).first(points_));
  return std::ranges::min(std::span(mean).first(points_));
}

template <int dim>
ShapeVolumes ElementsOfShape<dim>::shape(std::span<const double> q) const {
  constexpr double none = std::numeric_limits<double>::infinity();
  ShapeVolumes shape{std::vector<double>(solids_.regions.size(), 0.0), none, none, 0};
  for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
    const Vectors places = gathered(e, q);
    for (std::size_t k = 0; k < points_; ++k) {
      const double J = deformation(places, e, k).determinant();
      shape.of_region[at(mesh_.region[e])] += weight(e, k) * J;
      if (!(J >= shape.least)) shape.least = J, shape.worst = e;
    }
    if (is_dilated(e) && !small_strains(law(e)))
      shape.least_seen = std::min(shape.least_seen, least_mean_dilatation(places, e));
  }
  shape.least_seen = std::min(shape.least_seen, shape.least);
  return shape;
}

/// Bounds omega^2: that of an element alone is at most the largest row sum of |M^-1 K|, and that of a mesh at most that
/// of its elements (B. M. Irons, J. Eng. Mech. Div. 97 (1971) 1219-1225), each with its own part of the lumped masses.
template <int dim>
double ElementsOfShape<dim>::frequency_bound(std::span<const double> q, std::span<const double> lumped) const {
  const auto of_element = [&](std::size_t e) {
    std::array<double, most_unknowns * most_unknowns> all;
    const std::span<double> K = std::span(all).first(unknowns_ * unknowns_);
    find_tangent({StressAt::end, q, q}, e, {}, K);
    double volume = 0, largest = 0;
    for (std::size_t k = 0; k < points_; ++k) volume += weight(e, k);
    const double share = density(e) * volume / static_cast<double>(nodes_);
    for (std::size_t row = 0; row < unknowns_; ++row) {
      double sum = 0;
      for (std::size_t column = 0; column < unknowns_; ++column) sum += std::abs(K[row * unknowns_ + column]);
      const double whole = lumped[node(e, row / dim)];
      largest = std::max(largest, sum / std::min(share, whole));
    }
    return largest;
  };
  return std::sqrt(largest_of(team_, mesh_.element_count(), of_element, elements_of_a_block));
}

}  // namespace tether::fem
