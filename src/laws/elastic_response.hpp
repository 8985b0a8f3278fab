// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <string_view>

#include "base/words.hpp"

namespace tether {

// Symmetric tensors, and what laws of elastic bodies are asked and answer.

/// Symmetric tensors by their components 11, 22, 12 (plane) or 11, 22, 33, 12, 23, 13 (space), shear once.
template <int dim>
constexpr int component_count() {
  return dim == 2 ? 3 : 6;
}
template <int dim>
using Symmetric = Eigen::Matrix<double, component_count<dim>(), 1>;
/// d (a symmetric tensor) / d (a symmetric tensor): its columns are for one off-diagonal component, of which the tensor
/// has two, so that dS = D dE holds with the shears of dE counted twice.
template <int dim>
using SymmetricMap = Eigen::Matrix<double, component_count<dim>(), component_count<dim>()>;

/// Weights of the components in the product A : B.
template <int dim>
Symmetric<dim> contraction_weights() {
  if constexpr (dim == 2) {
    return {1, 1, 2};
  } else {
    return (Symmetric<dim>() << 1, 1, 1, 2, 2, 2).finished();
  }
}

/// A : B
template <int dim>
double contract(const Symmetric<dim>& a, const Symmetric<dim>& b) {
  return a.cwiseProduct(contraction_weights<dim>()).dot(b);
}

template <int dim>
Eigen::Matrix<double, dim, dim> full(const Symmetric<dim>& a) {
  if constexpr (dim == 2) {
    return (Eigen::Matrix2d() << a[0], a[2], a[2], a[1]).finished();
  } else {
    return (Eigen::Matrix3d() << a[0], a[3], a[5], a[3], a[1], a[4], a[5], a[4], a[2]).finished();
  }
}

template <int dim>
Symmetric<dim> symmetric(const Eigen::Matrix<double, dim, dim>& m) {
  if constexpr (dim == 2) {
    return {m(0, 0), m(1, 1), 0.5 * (m(0, 1) + m(1, 0))};
  } else {
    return (Symmetric<dim>() << m(0, 0), m(1, 1), m(2, 2), 0.5 * (m(0, 1) + m(1, 0)), 0.5 * (m(1, 2) + m(2, 1)),
            0.5 * (m(0, 2) + m(2, 0)))
        .finished();
  }
}

/// What a hyperelastic law answers to C = F^T F, or a linear one to 1 + 2 eps.
template <int dim>
struct Response {
  double energy = 0;    ///< Psi [energy/volume]
  Symmetric<dim> S;     ///< 2 dPsi/dC, second Piola-Kirchhoff [stress]
  SymmetricMap<dim> D;  ///< 2 dS/dC [stress]
};

/// What holds the third direction of a plane body.
enum class Plane { strain, stress };

/// The third direction of a plane body: its stretch, and the second Piola-Kirchhoff stress along it [stress].
struct Across {
  double stretch = 1, S = 0;
};

/// Lame's constants of E and nu [stress].
struct Lame {
  double lambda = 0, mu = 0;
};
/// Poisson's ratio of these, in space or plane strain.
inline double poisson_ratio(const Lame& l) { return l.lambda / (2 * (l.lambda + l.mu)); }
inline Lame lame(double E, double nu) { return {E * nu / ((1 + nu) * (1 - 2 * nu)), E / (2 * (1 + nu))}; }

/// How a neo-Hookean body resists a change of volume: lambda/2 ln(J)^2, lambda/2 (J - 1)^2, or
/// lambda/4 (J^2 - 1 - 2 ln J).
enum class Volumetric { log, square, mixed };
template <>
inline constexpr std::array<Word<Volumetric>, 3> words<Volumetric>{
    {{Volumetric::log, "log"}, {Volumetric::square, "square"}, {Volumetric::mixed, "mixed"}}};

/// What the deck says of an elastic region.
struct ElasticConstants {
  double E = 0, nu = 0;  // matr(1), matr(2) [stress], number
  Plane plane = Plane::strain;
  Volumetric volumetric = Volumetric::log;
  double centre_x = 0, centre_y = 0;  // of fibres [length]
};

/// One of a law's numbers, for people.
struct NamedNumber {
  std::string_view name;
  double value = 0;
};

/// A place of the shape at the start in the plane [length]: what a law whose material differs from place to place asks.
struct ReferencePlace {
  double X = 0, Y = 0;
};

}  // namespace tether
