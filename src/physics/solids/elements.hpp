// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "algebra/sparse_matrix.hpp"
#include "base/team.hpp"
#include "base/vec.hpp"
#include "laws/hyperelastic.hpp"
#include "model/solids.hpp"

namespace tether::fem {

/// Where the stress of a step is taken, q0 at its start and q1 at its end: Gonzalez' discrete gradient between them, at
/// the middle, or at the end.
enum class StressAt { gradient, middle, end };

/// Volumes of a shape: each region's, and where an element is nearest to being turned inside out.
struct ShapeVolumes {
  std::vector<double> of_region;
  double least = 0;       ///< det F at a point of quadrature
  double least_seen = 0;  ///< the same, or the mean dilatation that a law of finite strains sees there, if that is less
  std::size_t worst = 0;  ///< its element
};

/// Numbers that nodal_stress has of a node: six of the stress, and the energy density.
constexpr std::size_t stress_parts = 6, energy_field = stress_parts, stress_fields = energy_field + 1;

/// The elements of a mesh with their laws: integrals over them. Vectors have dim numbers a node, [length] or [force].
class Elements {
 public:
  virtual ~Elements() = default;

  /// Adds the internal forces f_A = sum_B q_B <grad N_A, S grad N_B> (13), q and S where `at` says.
  virtual void add_forces(StressAt at, std::span<const double> q0, std::span<const double> q1,
                          std::span<double> f) const = 0;
  /// Adds their derivative by q1, and `inertia` times the consistent mass matrix. Where `stresses` are given, as
  /// predict_stress() makes them, the derivative of the shape's turning takes these in place of the stress at q1.
  virtual void add_tangent(StressAt at, std::span<const double> q0, std::span<const double> q1, double inertia,
                           const NodalPattern& pattern, SparseMatrix& K,
                           std::span<const double> stresses = {}) const = 0;
  /// Adds the derivative of the internal forces at q; with `convex` each point's part of it, d2Psi/dF dF, is made
  /// positive semi-definite first: negative eigenvalues become 0 (J. Teran, E. Sifakis, G. Irving and R. Fedkiw, Symp.
  /// Computer Animation 2005, 181-190).
  virtual void add_stiffness(std::span<const double> q, bool convex, const NodalPattern& pattern,
                             SparseMatrix& K) const = 0;
  /// The stress S at all points of quadrature with its linear change by a change of q1: what it is after a correction
  /// of Newton's method before the shape's turning, which is of second order, stretches slender bodies (D. Magisano, L.
  /// Leonetti and G. Garcea, Comput. Methods Appl. Mech. Engrg 313 (2017) 989-1005). 3 numbers a point in the plane, 6
  /// in space.
  virtual void predict_stress(StressAt at, std::span<const double> q0, std::span<const double> q1,
                              std::span<const double> change, std::vector<double>& stresses) const = 0;
  /// Energy stored at q [energy].
  virtual double strain_energy(std::span<const double> q) const = 0;
  /// Cauchy's stress xx, yy, zz, xy, yz, xz, as fit_stress() makes it, and the energy density at the nodes, the mean of
  /// what the elements that meet there have at them; `stress_fields` numbers a node. In the plane yz, xz are 0.
  virtual std::vector<double> nodal_stress(std::span<const double> q) const = 0;
  /// The consistent mass matrix <rho N_A, N_B> (9), one number a pair of nodes.
  virtual SparseMatrix mass() const = 0;
  /// The volume of one region parted among its nodes, as lumped masses are: by the diagonals of its elements' matrices.
  /// All are positive, where row sums of order 2 are not: those of a triangle's corners are 0, of a tetrahedron's below
  /// [volume].
  virtual std::vector<double> lumped_volumes(int region) const = 0;
  /// <N_A> of one region, for forces in its volume [volume].
  virtual std::vector<double> volumes(int region) const = 0;
  /// Returns the volumes of the shape at q.
  virtual ShapeVolumes shape(std::span<const double> q) const = 0;
  /// A bound on the highest frequency with lumped masses at q: the largest of the elements alone [1/time].
  virtual double frequency_bound(std::span<const double> q, std::span<const double> lumped) const = 0;
};

// What a step does at one point of quadrature, from the deformation gradients at the step's start and end. Nothing here
// allocates. The laws are compiled once a dimension, in elements.cpp, and not again for each shape of elements.

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
/// at the start. D is set where the modulus is asked.
template <int dim, bool with_modulus>
PointStress<dim> point_stress(StressAt rule, const ElasticLaw& law, const Square<dim>& F0, const Square<dim>& F1,
                              double X, double Y);

/// Sets S to Gonzalez' stress between C0 and C1, at the place X, Y of the shape at the start, and D to its derivative
/// by E1: where both are the same, the law's own stress and half its modulus. D is set where the modulus is asked.
template <int dim, bool with_modulus>
void gradient_stress(const Symmetric<dim>& C0, const Symmetric<dim>& C1, const ElasticLaw& law, const Vec<2>& place,
                     PointStress<dim>& at);

/// Energy density at F, at the place X, Y of the shape at the start.
template <int dim>
double energy_at(const ElasticLaw& law, const Square<dim>& F, double X, double Y);

/// Energy density, second Piola-Kirchhoff stress and modulus there.
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

/// The derivative of P = A S by F, of what point_stress() answers: number j dim + i is P_ij, or F_ij. Of the stress at
/// the end it is d2Psi/dF dF.
template <int dim>
using GradientModulus = Eigen::Matrix<double, dim * dim, dim * dim>;
template <int dim>
GradientModulus<dim> gradient_modulus(const PointStress<dim>& s);

/// The nearest positive semi-definite matrix.
template <int dim>
GradientModulus<dim> convex(const GradientModulus<dim>& H);
/// Makes a symmetric matrix of n rows the nearest positive semi-definite one.
void make_convex(int n, std::span<double> matrix);

}  // namespace tether::fem
