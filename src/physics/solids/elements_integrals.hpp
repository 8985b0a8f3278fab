// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/solids/elements_of_shape.hpp"

namespace tether::fem {

// Integrals over elements that a run asks for once, or once a step.

template <class Shapes>
auto ElementsOf<Shapes>::element_mass(std::size_t e) const -> MassMatrix {
  MassMatrix m{};
  for (int k = 0; k < mass_points; ++k) {
    const auto& N = mass_values_[index(k)];
    const double w = mass_weight(e, k) * density(e);
    for (std::size_t ab = 0; ab < m.size(); ++ab) m[ab] += w * N[ab / nodes] * N[ab % nodes];
  }
  return m;
}

template <class Shapes>
SparseMatrix ElementsOf<Shapes>::mass() const {
  const NodalPattern pattern(1, mesh_.node_count(), mesh_.nodes, nodes);
  SparseMatrix M = pattern.matrix();
  for (std::size_t e = 0; e < mesh_.element_count(); ++e) pattern.add(e, element_mass(e), M);
  return M;
}

/// Adds `inertia` times the mass matrix, for each direction.
template <class Shapes>
void ElementsOf<Shapes>::add_inertia(std::size_t e, double inertia, Matrix& K) const {
  const MassMatrix m = element_mass(e);
  for (int a = 0; a < nodes; ++a) {
    for (int b = 0; b < nodes; ++b) {
      for (int i = 0; i < dim; ++i) K(a * dim + i, b * dim + i) += inertia * m[index(a * nodes + b)];
    }
  }
}

/// The diagonal of an element's mass matrix, scaled to its volume (E. Hinton, T. Rock and O. C. Zienkiewicz, Earthquake
/// Engng Struct. Dyn. 4 (1976) 245-249); for linear functions these are the row sums.
template <class Shapes>
std::vector<double> ElementsOf<Shapes>::lumped_volumes(int region) const {
  std::vector<double> lumped(mesh_.node_count(), 0.0);
  for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
    if (mesh_.region[e] != region) continue;
    Values<nodes> diagonal{};
    double volume = 0, trace = 0;
    for (int k = 0; k < mass_points; ++k) {
      const double w = mass_weight(e, k);
      volume += w;
      for (int a = 0; a < nodes; ++a)
        diagonal[index(a)] += w * mass_values_[index(k)][index(a)] * mass_values_[index(k)][index(a)];
    }
    for (const double value : diagonal) trace += value;
    for (int a = 0; a < nodes; ++a)
      lumped[static_cast<std::size_t>(mesh_.element(e)[a])] += diagonal[index(a)] * volume / trace;
  }
  return lumped;
}

template <class Shapes>
std::vector<double> ElementsOf<Shapes>::volumes(int region) const {
  std::vector<double> volumes(mesh_.node_count(), 0.0);
  for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
    if (mesh_.region[e] != region) continue;
    for (int k = 0; k < points; ++k) {
      for (int a = 0; a < nodes; ++a)
        volumes[static_cast<std::size_t>(mesh_.element(e)[a])] += weight(e, k) * values_[index(k)][index(a)];
    }
  }
  return volumes;
}

template <class Shapes>
double ElementsOf<Shapes>::least_mean_dilatation(const Places& at, std::size_t e) const {
  std::array<double, std::size_t{points}> J, mean;
  for (int k = 0; k < points; ++k) J[index(k)] = deformation(at, e, k).determinant();
  modes_of(e).average(J, mean);
  return std::ranges::min(mean);
}

template <class Shapes>
ShapeVolumes ElementsOf<Shapes>::shape(std::span<const double> q) const {
  constexpr double none = std::numeric_limits<double>::infinity();
  ShapeVolumes shape{std::vector<double>(solids_.regions.size(), 0.0), none, none, 0};
  for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
    const Places at = gathered(e, q);
    for (int k = 0; k < points; ++k) {
      const double J = deformation(at, e, k).determinant();
      shape.of_region[static_cast<std::size_t>(mesh_.region[e])] += weight(e, k) * J;
      if (!(J >= shape.least)) shape.least = J, shape.worst = e;
    }
    if (is_dilated(e) && !small_strains(law(e)))
      shape.least_seen = std::min(shape.least_seen, least_mean_dilatation(at, e));
  }
  shape.least_seen = std::min(shape.least_seen, shape.least);
  return shape;
}

/// Bounds omega^2: that of an element alone is at most the largest row sum of |M^-1 K|, and that of a mesh at most that
/// of its elements (B. M. Irons, J. Eng. Mech. Div. 97 (1971) 1219-1225), each with its own part of the lumped masses.
template <class Shapes>
double ElementsOf<Shapes>::frequency_bound(std::span<const double> q, std::span<const double> lumped) const {
  const auto of_element = [&](std::size_t e) {
    ElementMatrix K;
    element_tangent(StressAt::end, e, q, q, 0, {}, K);
    double volume = 0, largest = 0;
    for (int k = 0; k < points; ++k) volume += weight(e, k);
    for (int row = 0; row < unknowns; ++row) {
      double sum = 0;
      for (int column = 0; column < unknowns; ++column) sum += std::abs(K[index(row * unknowns + column)]);
      const double share = density(e) * volume / nodes;
      const double whole = lumped[static_cast<std::size_t>(mesh_.element(e)[row / dim])];
      largest = std::max(largest, sum / std::min(share, whole));
    }
    return largest;
  };
  return std::sqrt(largest_of(team_, mesh_.element_count(), of_element, elements_of_a_block));
}

}  // namespace tether::fem
