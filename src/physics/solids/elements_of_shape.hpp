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
#include "physics/solids/mean_dilatation.hpp"
#include "physics/solids/stress_recovery.hpp"

namespace tether::fem {

/// Elements of one shape; the gradients of all points of quadrature are kept.
template <class Shapes>
class ElementsOf final : public Elements {
 public:
  static constexpr int dim = Shapes::dim, nodes = Shapes::nodes, points = Shapes::points, unknowns = dim * nodes;
  static constexpr int mass_points = Shapes::mass_points;
  static constexpr bool one_rule = mass_points == points;  // which is that of gradients for masses, too
  /// Functions that the mean dilatation is made of: a number an element; of order 2 in a product of lines, of degree 1.
  static constexpr std::size_t modes = Shapes::order == 2 && !Shapes::is_simplex ? dim + 1 : 1;
  static constexpr std::size_t parts = component_count<dim>();  // of a symmetric tensor
  using Vector = Eigen::Matrix<double, dim, 1>;
  using Places = Eigen::Matrix<double, dim, nodes>;
  using ElementMatrix = std::array<double, static_cast<std::size_t>(unknowns* unknowns)>;
  static constexpr std::size_t elements_of_a_block = 64;

  ElementsOf(const Solids& solids, Team& team) : team_(team), solids_(solids), mesh_(solids.mesh) {
    const std::size_t count = mesh_.element_count() * points;
    gradients_.reserve(count), weights_.reserve(count), places_.reserve(count);
    for (int k = 0; k < points; ++k) values_[index(k)] = Shapes::values(Shapes::place(k));
    for (int k = 0; k < mass_points; ++k) mass_values_[index(k)] = Shapes::values(Shapes::mass_place(k));
    for (const SolidRegion& region : solids.regions)
      dilated_.push_back(dilatation_of(solids.dilatation, mesh_.kind, region.law));
    for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
      for (int k = 0; k < points; ++k) add_point(e, k);
      for (int k = 0; !one_rule && k < mass_points; ++k)
        mass_weights_.push_back(jacobian_at<Shapes>(mesh_, e, Shapes::mass_place(k)).determinant *
                                Shapes::mass_weight(k));
      if (std::ranges::any_of(dilated_, &DilatationChoice::mean)) add_modes(e);
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
        team_, mesh_.element_count(), [&](std::size_t e, ElementMatrix& k) { element_stiffness(e, q, convex, k); },
        [&](std::size_t e, const ElementMatrix& k) { pattern.add(e, k, K); });
  }

  void predict_stress(StressAt at, std::span<const double> q0, std::span<const double> q1,
                      std::span<const double> change, std::vector<double>& stresses) const override {
    stresses.resize(mesh_.element_count() * points * parts);
    team_.each(0, mesh_.element_count(), [&](std::size_t e) {
      const Places by = gathered(e, change);
      const Points points_of = stresses_at(at, e, gathered(e, q0), gathered(e, q1), true);
      for (int k = 0; k < points; ++k) {
        const auto& s = points_of.at[index(k)].s;
        Symmetric<dim> strain = Symmetric<dim>::Zero();
        for (int a = 0; a < nodes; ++a) strain += strain_map<dim>(s.F, gradients(e, k).col(a)) * by.col(a);
        Eigen::Map<Symmetric<dim>> predicted(&stresses[(e * points + index(k)) * parts]);
        predicted = s.S + s.D * strain;
      }
      if (points_of.dilated) add_dilatation_to_stress(e, points_of, by, stresses);
    });
  }

  double strain_energy(std::span<const double> q) const override {
    return sum_of_blocks(
        team_, mesh_.element_count(),
        [&](std::size_t begin, std::size_t end) {
          double energy = 0;
          for (std::size_t e = begin; e < end; ++e) {
            const SeenByLaw seen = seen_by_law(gathered(e, q), e);
            for (int k = 0; k < points; ++k) {
              const double left_out = seen.left_out[index(k)];
              energy += weight(e, k) * (energy_at<dim>(law(e), seen.F[index(k)], place(e, k)[0], place(e, k)[1]) +
                                        0.5 * stabiliser(e) * left_out * left_out);
            }
          }
          return energy;
        },
        elements_of_a_block);
  }

  std::vector<double> nodal_stress(std::span<const double> q) const override;
  SparseMatrix mass() const override;
  std::vector<double> lumped_volumes(int region) const override;
  std::vector<double> volumes(int region) const override;
  ShapeVolumes shape(std::span<const double> q) const override;
  double frequency_bound(std::span<const double> q, std::span<const double> lumped) const override;

 private:
  std::array<double, stress_fields> cauchy_stress(std::size_t e, int k, const Square<dim>& F) const;
  using StressAtPoints = std::array<std::array<double, stress_fields>, std::size_t{points}>;
  StressAtPoints stress_at_points(std::size_t e, const Places& places) const;
  auto stress_at_nodes(const StressAtPoints& there) const;
  void add_samples(std::size_t e, const StressAtPoints& there, StressSamples& samples) const;
  static std::size_t index(int k) { return static_cast<std::size_t>(k); }

  using Gradients = std::array<Square<dim>, std::size_t{points}>;
  using Row = Eigen::Matrix<double, unknowns, 1>;
  using Matrix = Eigen::Map<Eigen::Matrix<double, unknowns, unknowns, Eigen::RowMajor>>;
  /// The stresses at all points of an element; where the law sees the mean dilatation, how they change with it.
  struct Points {
    std::array<DilatedPoint<dim>, std::size_t{points}> at;
    bool dilated = false;
  };

  void add_modes(std::size_t e) {
    Eigen::Matrix<double, dim, points> places;
    for (int k = 0; k < points; ++k) places.col(k) = place_of_point(e, k);
    add_dilatation_modes(std::span(weights_).last(points), std::span(places.data(), std::size_t{points * dim}),
                         modes > 1, modes_);
  }
  DilatationModes modes_of(std::size_t e) const {
    return {std::span(weights_).subspan(e * points, points),
            std::span(modes_).subspan(e * points * modes, points * modes), stabiliser(e)};
  }
  bool is_dilated(std::size_t e) const { return dilated_[static_cast<std::size_t>(mesh_.region[e])].mean; }
  double stabiliser(std::size_t e) const { return dilated_[static_cast<std::size_t>(mesh_.region[e])].stabiliser; }

  void add_point(std::size_t e, int k) {
    const auto map = jacobian_at<Shapes>(mesh_, e, Shapes::place(k));
    gradients_.push_back(Eigen::Map<const Places>(map.gradients.data()));
    weights_.push_back(map.determinant * Shapes::weight(k));
    const Vector place = place_of_point(e, k);
    places_.push_back({place[0], place[1]});
  }
  Vector place_of_point(std::size_t e, int k) const {
    return gathered(e, mesh_.x) * Eigen::Map<const Eigen::Matrix<double, nodes, 1>>(values_[index(k)].data());
  }
  const ElasticLaw& law(std::size_t e) const { return solids_.regions[static_cast<std::size_t>(mesh_.region[e])].law; }
  double density(std::size_t e) const { return solids_.regions[static_cast<std::size_t>(mesh_.region[e])].density; }
  const Places& gradients(std::size_t e, int k) const { return gradients_[e * points + index(k)]; }
  double weight(std::size_t e, int k) const { return weights_[e * points + index(k)]; }
  double mass_weight(std::size_t e, int k) const {
    return one_rule ? weight(e, k) : mass_weights_[e * mass_points + index(k)];
  }
  const Vec<2>& place(std::size_t e, int k) const { return places_[e * points + index(k)]; }

  Places gathered(std::size_t e, std::span<const double> q) const {
    Places at;
    for (int a = 0; a < nodes; ++a) {
      at.col(a) = Eigen::Map<const Vector>(&q[static_cast<std::size_t>(mesh_.element(e)[a]) * dim]);
    }
    return at;
  }
  Square<dim> deformation(const Places& at, std::size_t e, int k) const { return at * gradients(e, k).transpose(); }
  Gradients deformations(const Places& at, std::size_t e) const {
    Gradients F;
    for (int k = 0; k < points; ++k) F[index(k)] = deformation(at, e, k);
    return F;
  }
  /// What the law takes for F at the points, and what is left out of the dilatation.
  struct SeenByLaw {
    Gradients F;
    std::array<double, std::size_t{points}> left_out{};
  };
  SeenByLaw seen_by_law(const Places& at, std::size_t e) const {
    SeenByLaw seen{deformations(at, e)};
    if (is_dilated(e)) take_mean_dilatation<dim>(law(e), modes_of(e), seen.F, seen.left_out);
    return seen;
  }

  double least_mean_dilatation(const Places& at, std::size_t e) const;
  template <bool with_modulus>
  PointStress<dim> stress(StressAt rule, std::size_t e, int k, const Places& at0, const Places& at1) const {
    return point_stress<dim, with_modulus>(rule, law(e), deformation(at0, e, k), deformation(at1, e, k), place(e, k)[0],
                                           place(e, k)[1]);
  }
  Points stresses_at(StressAt rule, std::size_t e, const Places& at0, const Places& at1, bool with_modulus) const {
    Points all;
    all.dilated = is_dilated(e);
    if (all.dilated) {
      const Gradients F0 = deformations(at0, e), F1 = deformations(at1, e);
      dilated_stresses<dim>(rule, law(e), F0, F1, std::span(places_).subspan(e * points, points), modes_of(e),
                            with_modulus, all.at);
      return all;
    }
    for (int k = 0; k < points; ++k)
      all.at[index(k)].s = with_modulus ? stress<true>(rule, e, k, at0, at1) : stress<false>(rule, e, k, at0, at1);
    return all;
  }

  Places element_forces(StressAt rule, std::size_t e, std::span<const double> q0, std::span<const double> q1) const {
    const Points all = stresses_at(rule, e, gathered(e, q0), gathered(e, q1), false);
    Places sum = Places::Zero();
    for (int k = 0; k < points; ++k) {
      const auto& s = all.at[index(k)].s;
      sum += weight(e, k) * (s.A * full<dim>(s.S)) * gradients(e, k);
    }
    return sum;
  }

  void element_tangent(StressAt rule, std::size_t e, std::span<const double> q0, std::span<const double> q1,
                       double inertia, std::span<const double> stresses, ElementMatrix& out) const {
    Points all = stresses_at(rule, e, gathered(e, q0), gathered(e, q1), true);
    Matrix K(out.data());
    K.setZero();
    for (int k = 0; k < points; ++k) {
      auto& s = all.at[index(k)].s;
      if (!stresses.empty()) s.S = Eigen::Map<const Symmetric<dim>>(&stresses[(e * points + index(k)) * parts]);
      add_point_tangent(s, gradients(e, k), weight(e, k), K);
    }
    if (all.dilated) add_dilatation_tangent(e, all, K);
    if (inertia != 0) add_inertia(e, inertia, K);
  }

  /// Makes each of the law's own points convex for itself, and what the mean dilatation ties together as a whole.
  void element_stiffness(std::size_t e, std::span<const double> q, bool made_convex, ElementMatrix& out) const {
    if (!made_convex || is_dilated(e)) {
      element_tangent(StressAt::end, e, q, q, 0, {}, out);
      if (made_convex) make_convex(unknowns, out);
      return;
    }
    const Places at = gathered(e, q);
    Matrix K(out.data());
    K.setZero();
    for (int k = 0; k < points; ++k) {
      const GradientModulus<dim> H = convex<dim>(gradient_modulus<dim>(stress<true>(StressAt::end, e, k, at, at)));
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

  /// An element's mass matrix, a number a pair of nodes.
  using MassMatrix = std::array<double, static_cast<std::size_t>(nodes* nodes)>;
  MassMatrix element_mass(std::size_t e) const;
  void add_inertia(std::size_t e, double inertia, Matrix& K) const;

  /// Returns B(F)^T times a tensor, by nodes: what a change of place does to a scalar with that derivative by E.
  static Row by_places(const Square<dim>& F, const Symmetric<dim>& by_strain, const Places& G) {
    const Places row = F * full<dim>(by_strain) * G;
    return Eigen::Map<const Row>(row.data());
  }

  void add_dilatation_tangent(std::size_t e, const Points& all, Matrix& K) const;
  void add_dilatation_to_stress(std::size_t e, const Points& all, const Places& by,
                                std::vector<double>& stresses) const;

  static void add_point_tangent(const PointStress<dim>& s, const Places& G, double w, Matrix& K) {
    const Places SG = s.geometric * full<dim>(s.S) * G;
    Eigen::Matrix<double, component_count<dim>(), unknowns> left, right;
    for (int a = 0; a < nodes; ++a) {
      left.template middleCols<dim>(a * dim) = strain_map<dim>(s.A, G.col(a));
      right.template middleCols<dim>(a * dim) = strain_map<dim>(s.F, G.col(a));
    }
    K.noalias() += left.transpose() * (w * s.D * right);
    for (int a = 0; a < nodes; ++a) {
      for (int b = 0; b < nodes; ++b) {
        const double diagonal = w * G.col(a).dot(SG.col(b));
        for (int i = 0; i < dim; ++i) K(a * dim + i, b * dim + i) += diagonal;
      }
    }
  }

  Team& team_;
  const Solids& solids_;
  const Mesh& mesh_;
  std::array<Values<nodes>, std::size_t{points}> values_;
  std::array<Values<nodes>, std::size_t{mass_points}> mass_values_;
  std::vector<Places> gradients_;
  std::vector<double> weights_, mass_weights_, modes_;
  std::vector<DilatationChoice> dilated_;  // of each region
  std::vector<Vec<2>> places_;
};

}  // namespace tether::fem
