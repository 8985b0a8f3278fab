// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/vec.hpp"
#include "grid/shapes.hpp"
#include "loops/elements.hpp"
#include "physics/solids/elements.hpp"

namespace tether::fem {

/// Elements of one shape; the gradients of all points of quadrature are kept.
template <class Shapes>
class ElementsOf final : public Elements {
 public:
  static constexpr int dim = Shapes::dim, nodes = Shapes::nodes, points = Shapes::points, unknowns = dim * nodes;
  static constexpr std::size_t parts = component_count<dim>();  // of a symmetric tensor
  using Vector = Eigen::Matrix<double, dim, 1>;
  using Places = Eigen::Matrix<double, dim, nodes>;
  using ElementMatrix = std::array<double, static_cast<std::size_t>(unknowns* unknowns)>;
  static constexpr std::size_t elements_of_a_block = 64;

  ElementsOf(const Solids& solids, Team& team) : team_(team), solids_(solids), mesh_(solids.mesh) {
    const std::size_t count = mesh_.element_count() * points;
    gradients_.reserve(count), weights_.reserve(count), places_.reserve(count);
    for (int k = 0; k < points; ++k) values_[index(k)] = Shapes::values(Shapes::place(k));
    for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
      for (int k = 0; k < points; ++k) add_point(e, k);
    }
  }

  void add_forces(StressAt at, std::span<const double> q0, std::span<const double> q1,
                  std::span<double> f) const override {
    compute_then_add<Places>(
        team_, mesh_.element_count(), [&](std::size_t e, Places& sum) { sum = element_forces(at, e, q0, q1); },
        [&](std::size_t e, const Places& sum) {
          for (int a = 0; a < nodes; ++a)
            Eigen::Map<Vector>(&f[static_cast<std::size_t>(mesh_.element(e)[a]) * dim]) += sum.col(a);
        });
  }

  void add_tangent(StressAt at, std::span<const double> q0, std::span<const double> q1, double inertia,
                   const NodalPattern& pattern, SparseMatrix& K, std::span<const double> stresses) const override {
    compute_then_add<ElementMatrix>(
        team_, mesh_.element_count(),
        [&](std::size_t e, ElementMatrix& k) { element_tangent(at, e, q0, q1, inertia, stresses, k); },
        [&](std::size_t e, const ElementMatrix& k) { pattern.add(e, k, K); });
  }

  void add_stiffness(std::span<const double> q, bool convex, const NodalPattern& pattern,
                     SparseMatrix& K) const override {
    compute_then_add<ElementMatrix>(
        team_, mesh_.element_count(),
        [&](std::size_t e, ElementMatrix& k) { element_stiffness(e, gathered(e, q), convex, k); },
        [&](std::size_t e, const ElementMatrix& k) { pattern.add(e, k, K); });
  }

  void predict_stress(StressAt at, std::span<const double> q0, std::span<const double> q1,
                      std::span<const double> change, std::vector<double>& stresses) const override {
    stresses.resize(mesh_.element_count() * points * parts);
    team_.each(0, mesh_.element_count(), [&](std::size_t e) {
      const Places at0 = gathered(e, q0), at1 = gathered(e, q1), by = gathered(e, change);
      for (int k = 0; k < points; ++k) {
        const auto s = stress<true>(at, e, k, at0, at1);
        Symmetric<dim> strain = Symmetric<dim>::Zero();
        for (int a = 0; a < nodes; ++a) strain += strain_map<dim>(s.F, gradients(e, k).col(a)) * by.col(a);
        Eigen::Map<Symmetric<dim>> predicted(&stresses[(e * points + index(k)) * parts]);
        predicted = s.S + s.D * strain;
      }
    });
  }

  double strain_energy(std::span<const double> q) const override {
    return sum_of_blocks(
        team_, mesh_.element_count(),
        [&](std::size_t begin, std::size_t end) {
          double energy = 0;
          for (std::size_t e = begin; e < end; ++e) {
            const Places at = gathered(e, q);
            for (int k = 0; k < points; ++k)
              energy += weight(e, k) * energy_at<dim>(law(e), deformation(at, e, k), place(e, k)[0], place(e, k)[1]);
          }
          return energy;
        },
        elements_of_a_block);
  }

  std::vector<double> nodal_stress(std::span<const double> q) const override;
  SparseMatrix mass() const override;
  std::vector<double> lumped_mass() const override;
  std::vector<double> volumes(int region) const override;
  ShapeVolumes shape(std::span<const double> q) const override;
  double frequency_bound(std::span<const double> q, std::span<const double> lumped) const override;

 private:
  std::array<double, stress_fields> cauchy_stress(std::size_t e, int k, const Square<dim>& F) const;
  auto stress_at_nodes(std::size_t e, const Places& places) const;
  static std::size_t index(int k) { return static_cast<std::size_t>(k); }

  void add_point(std::size_t e, int k) {
    const auto map = jacobian_at<Shapes>(mesh_, e, Shapes::place(k));
    gradients_.push_back(Eigen::Map<const Places>(map.gradients.data()));
    weights_.push_back(map.determinant * Shapes::weight(k));
    Vec<2> place{};
    for (int a = 0; a < nodes; ++a) {
      const double* x = &mesh_.x[static_cast<std::size_t>(mesh_.element(e)[a]) * dim];
      for (std::size_t i = 0; i < 2; ++i) place[i] += values_[index(k)][index(a)] * x[i];
    }
    places_.push_back(place);
  }
  const ElasticLaw& law(std::size_t e) const { return solids_.regions[static_cast<std::size_t>(mesh_.region[e])].law; }
  double density(std::size_t e) const { return solids_.regions[static_cast<std::size_t>(mesh_.region[e])].density; }
  const Places& gradients(std::size_t e, int k) const { return gradients_[e * points + index(k)]; }
  double weight(std::size_t e, int k) const { return weights_[e * points + index(k)]; }
  const Vec<2>& place(std::size_t e, int k) const { return places_[e * points + index(k)]; }

  Places gathered(std::size_t e, std::span<const double> q) const {
    Places at;
    for (int a = 0; a < nodes; ++a) {
      at.col(a) = Eigen::Map<const Vector>(&q[static_cast<std::size_t>(mesh_.element(e)[a]) * dim]);
    }
    return at;
  }
  Square<dim> deformation(const Places& at, std::size_t e, int k) const { return at * gradients(e, k).transpose(); }
  Response<dim> response(std::size_t e, int k, const Square<dim>& F) const {
    return response_at<dim>(law(e), F, place(e, k)[0], place(e, k)[1]);
  }

  template <bool with_modulus>
  PointStress<dim> stress(StressAt rule, std::size_t e, int k, const Places& at0, const Places& at1) const {
    return point_stress<dim, with_modulus>(rule, law(e), deformation(at0, e, k), deformation(at1, e, k), place(e, k)[0],
                                           place(e, k)[1]);
  }

  Places element_forces(StressAt rule, std::size_t e, std::span<const double> q0, std::span<const double> q1) const {
    const Places at0 = gathered(e, q0), at1 = gathered(e, q1);
    Places sum = Places::Zero();
    for (int k = 0; k < points; ++k) {
      const auto s = stress<false>(rule, e, k, at0, at1);
      sum += weight(e, k) * (s.A * full<dim>(s.S)) * gradients(e, k);
    }
    return sum;
  }

  void element_tangent(StressAt rule, std::size_t e, std::span<const double> q0, std::span<const double> q1,
                       double inertia, std::span<const double> stresses, ElementMatrix& out) const {
    const Places at0 = gathered(e, q0), at1 = gathered(e, q1);
    Eigen::Map<Eigen::Matrix<double, unknowns, unknowns, Eigen::RowMajor>> K(out.data());
    K.setZero();
    for (int k = 0; k < points; ++k) {
      auto s = stress<true>(rule, e, k, at0, at1);
      if (!stresses.empty()) s.S = Eigen::Map<const Symmetric<dim>>(&stresses[(e * points + index(k)) * parts]);
      add_point_tangent(s, gradients(e, k), weight(e, k), inertia * density(e), values_[index(k)], K);
    }
  }

  void element_stiffness(std::size_t e, const Places& at, bool made_convex, ElementMatrix& out) const {
    Eigen::Map<Eigen::Matrix<double, unknowns, unknowns, Eigen::RowMajor>> K(out.data());
    K.setZero();
    for (int k = 0; k < points; ++k) {
      GradientModulus<dim> H = gradient_modulus<dim>(stress<true>(StressAt::end, e, k, at, at));
      if (made_convex) H = convex<dim>(H);
      for (int b = 0; b < nodes; ++b) {
        Eigen::Matrix<double, dim * dim, dim> by = decltype(by)::Zero();  // dP by the place of node b
        for (int l = 0; l < dim; ++l) by += gradients(e, k)(l, b) * H.template middleCols<dim>(l * dim);
        for (int a = 0; a < nodes; ++a) {
          for (int j = 0; j < dim; ++j)
            K.template block<dim, dim>(a * dim, b * dim) +=
                weight(e, k) * gradients(e, k)(j, a) * by.template middleRows<dim>(j * dim);
        }
      }
    }
  }

  template <class Matrix>
  static void add_point_tangent(const PointStress<dim>& s, const Places& G, double w, double inertia,
                                const Values<nodes>& N, Matrix& K) {
    const Places SG = s.geometric * full<dim>(s.S) * G;
    Eigen::Matrix<double, component_count<dim>(), unknowns> left, right;
    for (int a = 0; a < nodes; ++a) {
      left.template middleCols<dim>(a * dim) = strain_map<dim>(s.A, G.col(a));
      right.template middleCols<dim>(a * dim) = strain_map<dim>(s.F, G.col(a));
    }
    K.noalias() += left.transpose() * (w * s.D * right);
    for (int a = 0; a < nodes; ++a) {
      for (int b = 0; b < nodes; ++b) {
        const double diagonal = w * (G.col(a).dot(SG.col(b)) + inertia * N[index(a)] * N[index(b)]);
        for (int i = 0; i < dim; ++i) K(a * dim + i, b * dim + i) += diagonal;
      }
    }
  }

  Team& team_;
  const Solids& solids_;
  const Mesh& mesh_;
  std::array<Values<nodes>, std::size_t{points}> values_;
  std::vector<Places> gradients_;
  std::vector<double> weights_;
  std::vector<Vec<2>> places_;
};

template <class Shapes>
SparseMatrix ElementsOf<Shapes>::mass() const {
  const NodalPattern pattern(1, mesh_.node_count(), mesh_.nodes, nodes);
  SparseMatrix M = pattern.matrix();
  std::array<double, static_cast<std::size_t>(nodes * nodes)> m;
  for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
    m.fill(0);
    for (int k = 0; k < points; ++k) {
      const auto& N = values_[index(k)];
      const double w = weight(e, k) * density(e);
      for (std::size_t ab = 0; ab < m.size(); ++ab) m[ab] += w * N[ab / nodes] * N[ab % nodes];
    }
    pattern.add(e, m, M);
  }
  return M;
}

/// The diagonal of an element's mass matrix, scaled to its mass (E. Hinton, T. Rock and O. C. Zienkiewicz, Earthquake
/// Engng Struct. Dyn. 4 (1976) 245-249); for linear functions these are the row sums.
template <class Shapes>
std::vector<double> ElementsOf<Shapes>::lumped_mass() const {
  std::vector<double> lumped(mesh_.node_count(), 0.0);
  for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
    Values<nodes> diagonal{};
    double mass = 0, trace = 0;
    for (int k = 0; k < points; ++k) {
      const double w = weight(e, k) * density(e);
      mass += w;
      for (int a = 0; a < nodes; ++a)
        diagonal[index(a)] += w * values_[index(k)][index(a)] * values_[index(k)][index(a)];
    }
    for (const double value : diagonal) trace += value;
    for (int a = 0; a < nodes; ++a)
      lumped[static_cast<std::size_t>(mesh_.element(e)[a])] += trace == 0 ? 0 : diagonal[index(a)] * mass / trace;
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
ShapeVolumes ElementsOf<Shapes>::shape(std::span<const double> q) const {
  ShapeVolumes shape{std::vector<double>(solids_.regions.size(), 0.0), std::numeric_limits<double>::infinity(), 0};
  for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
    const Places at = gathered(e, q);
    for (int k = 0; k < points; ++k) {
      const double J = deformation(at, e, k).determinant();
      shape.of_region[static_cast<std::size_t>(mesh_.region[e])] += weight(e, k) * J;
      if (!(J >= shape.least)) shape.least = J, shape.worst = e;
    }
  }
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
