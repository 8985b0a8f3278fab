// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "laws/materials/hyperelastic.hpp"
#include "solvers/fem/elements.hpp"

// What a step does at one point of quadrature, from the deformation gradients at the step's start and end. Nothing here
// allocates. The laws are compiled once a dimension, in element_kernels.cpp, and not again for each shape of elements.

namespace tether::fem {

template <int dim>
using Square = Eigen::Matrix<double, dim, dim>;

/// At a point: f_A += w A S grad N_A, with tangent w [a (grad N_A . S grad N_B) 1 + B_A(A)^T D B_B(F)], where B(F) maps
/// a change of place to the change of E = (F^T F - 1)/2, shears counted twice.
template <int dim>
struct PointStress {
  Square<dim> A, F;
  Symmetric<dim> S;
  SymmetricMap<dim> D;
  double geometric = 0;  // a
};

/// The stress of any law between the deformation gradients F0 and F1, by a step's rule, at the place X, Y of the shape
/// at the start.
template <int dim>
PointStress<dim> point_stress(StressAt rule, const ElasticLaw& law, const Square<dim>& F0, const Square<dim>& F1,
                              double X, double Y);

/// Energy density and second Piola-Kirchhoff stress at F.
template <int dim>
Response<dim> response_at(const ElasticLaw& law, const Square<dim>& F, double X, double Y);

/// The third direction of a plane body at F.
Across across_at(const ElasticLaw& law, const Square<2>& F);

/// B_A(F): change of E (shears twice) by the place of a node whose shape function has the gradient g.
template <int dim>
Eigen::Matrix<double, component_count<dim>(), dim> strain_map(const Square<dim>& F,
                                                              const Eigen::Matrix<double, dim, 1>& g) {
  Eigen::Matrix<double, component_count<dim>(), dim> B;
  for (int i = 0; i < dim; ++i) {
    for (int k = 0; k < dim; ++k) B(k, i) = F(i, k) * g[k];
    if constexpr (dim == 2) {
      B(2, i) = F(i, 0) * g[1] + F(i, 1) * g[0];
    } else {
      B(3, i) = F(i, 0) * g[1] + F(i, 1) * g[0];
      B(4, i) = F(i, 1) * g[2] + F(i, 2) * g[1];
      B(5, i) = F(i, 0) * g[2] + F(i, 2) * g[0];
    }
  }
  return B;
}

/// d2Psi/dF dF of what point_stress() answers: unknown j dim + i is F_ij.
template <int dim>
using GradientModulus = Eigen::Matrix<double, dim * dim, dim * dim>;
template <int dim>
GradientModulus<dim> gradient_modulus(const PointStress<dim>& s);

/// The nearest positive semi-definite matrix.
template <int dim>
GradientModulus<dim> convex(const GradientModulus<dim>& H);

}  // namespace tether::fem
